import { startCalibration } from "../api/guideCommands";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { EmptyState } from "../controls/EmptyState";
import { unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { FlowCard } from "../flow/FlowCard";
import { PictureView } from "../flow/PictureView";
import { Layout } from "../frame/Layout";
import { NextStep } from "../home/NextStep";
import { BoardIllustration } from "../object/Illustration";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { useAbsent } from "../state/useAbsent";
import { useProbe } from "../state/useProbe";

export function CalibratePage() {
  const view = useLive((s) => s.flow);
  const over = view && !view.running && view.actions.length === 0;
  if (!view || over) return <NotStarted />;
  return (
    <Layout picture={<PictureView key={view.picture.kind} picture={view.picture} />} card={<FlowCard view={view} />} />
  );
}

function NotStarted() {
  const touches = useProbe();
  const absent = useAbsent("arm", "sensor");
  const unit = unitOf("µm");
  const touching = `${t("ui-touch-faces-crenellated-object-arms-tip", { unit })} ${t("ui-flat-chessboard-laser-line-crosses-also")}`;
  return (
    <Layout
      picture={
        <EmptyState
          picture={touches ? undefined : <BoardIllustration />}
          title={touches ? t("ui-contact-points-few-pictures-calibrated-sensor") : t("ui-pictures-calibrated-sensor")}
          text={touches ? touching : t("ui-hold-sensor-over-chessboard", { unit })}
        />
      }
      card={
        <>
          <CardHead
            title={t("ui-calibrate-the-sensor")}
            text={touches ? t("ui-clamp-object-clean-tip-takes-few") : t("ui-lay-chessboard-down")}
          />
          <MainAct>
            <PressButton kind="primary" disabled={absent !== ""} why={absent} onPress={startCalibration}>
              {t("ui-start-calibration")}
            </PressButton>
          </MainAct>
          {absent && <NextStep />}
        </>
      }
    />
  );
}
