import { startCalibration } from "../api/guideCommands";
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
    <Layout picture={<PictureView key={view.picture.kind} picture={view.picture} />} card={<FlowCard view={view} />} />
  );
}

function NotStarted() {
  return (
    <Layout
      picture={
        <EmptyState
          title={t("ui-contact-points-few-pictures-calibrated-sensor")}
          text={`${t("ui-touch-faces-crenellated-object-arms-tip", { unit: unitOf("µm") })} ${t("ui-flat-chessboard-laser-line-crosses-also")}`}
        />
      }
      card={
        <>
          <CardHead title={t("ui-calibrate-the-sensor")} text={t("ui-clamp-object-clean-tip-takes-few")} />
          <MainAct>
            <PressButton kind="primary" onPress={startCalibration}>
              {t("ui-start-calibration")}
            </PressButton>
          </MainAct>
        </>
      }
    />
  );
}
