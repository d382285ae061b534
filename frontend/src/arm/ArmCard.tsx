import type { ArmView } from "../api/wire";
import { newFindings } from "../controls/findings";
import { SessionCard } from "../flow/SessionCard";
import { ArmChoice } from "./ArmChoice";
import { ArtefactField } from "./ArtefactField";
import { CoordinatesField } from "./CoordinatesField";
import { LimitField } from "./LimitField";

/** What to do in this step of a check or an identification. */
export function ArmCard({ view }: { view: ArmView }) {
  const choosing = view.step === "seat" && view.picture.seats.length === 0 && view.coordinates === 0;
  /* A sphere is touched, a seat is swung in. */
  const touching = view.step === "swing" && view.artefact.kind === "sphere";
  return (
    <SessionCard
      guide="arm"
      view={view}
      help={touching ? "touch" : view.step}
      verdict={view.step === "result"}
      findings={newFindings(view.findings, view.actions)}
    >
      {choosing && view.arms.length > 1 && <ArmChoice arms={view.arms} arm={view.arm} />}
      {view.step === "seat" && view.purpose !== "check" && (
        <ArtefactField artefact={view.artefact} disabled={view.busy !== null} only={view.purpose === "tip"} />
      )}
      {view.step === "seat" && view.purpose === "identify" && (
        <CoordinatesField points={view.coordinates} disabled={view.busy !== null} />
      )}
      {choosing && view.purpose !== "identify" && (
        <LimitField limit_um={view.picture.limit_um} tip={view.purpose === "tip"} />
      )}
    </SessionCard>
  );
}
