import { startFlow } from "../api/commands";
import { FlowCard } from "../flow/FlowCard";
import { PictureView } from "../flow/PictureView";
import { Layout } from "../frame/Layout";
import { MainAct } from "../parts/Actions";
import { CardHead } from "../parts/CardHead";
import { EmptyState } from "../parts/EmptyState";
import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
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
          title="From touches and a few pictures to a calibrated sensor"
          text={`You touch the faces of the crenellated object with the arm's tip, then hold the sensor over it and take a picture in each of a few poses; the station says which. It shows how good the result is, in ${unitOf("µm")}, before anything is replaced.`}
        />
      }
      card={
        <>
          <CardHead title="Calibrate the sensor" text="Have the object clamped and the tip clean. It takes a few minutes." />
          <MainAct>
            <PressButton kind="primary" onPress={startFlow}>
              Start calibration
            </PressButton>
          </MainAct>
        </>
      }
    />
  );
}
