import { startFlow } from "../api/commands";
import { FlowCard } from "../flow/FlowCard";
import { PictureView } from "../flow/PictureView";
import { Layout } from "../frame/Layout";
import { MainAct } from "../parts/Actions";
import { CardHead } from "../parts/CardHead";
import { EmptyState } from "../parts/EmptyState";
import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { t } from "../state/language";
import { useLive } from "../state/store";

export function CalibratePage() {
  const view = useLive((s) => s.flow);
  const over = view && !view.running && view.actions.length === 0;
  if (!view || over) return <NotStarted />;
  return (
    <Layout
      picture={<PictureView key={view.picture.kind} picture={view.picture} />}
      card={<FlowCard view={view} />}
    />
  );
}

function NotStarted() {
  return (
    <Layout
      picture={
        <EmptyState
          title={t("From touches and a few pictures to a calibrated sensor")}
          text={`${t("You touch the faces of the crenellated object with the arm's tip, then hold the sensor over it and take a picture in each of a few poses; the station says which. It shows how good the result is, in {unit}, before anything is replaced.", { unit: unitOf("µm") })} ${t("A flat chessboard that the laser's line crosses does as well, and need not be touched.")}`}
        />
      }
      card={
        <>
          <CardHead title={t("Calibrate the sensor")} text={t("Have the object clamped and the tip clean. It takes a few minutes.")} />
          <MainAct>
            <PressButton kind="primary" onPress={startFlow}>
              {t("Start calibration")}
            </PressButton>
          </MainAct>
        </>
      }
    />
  );
}
