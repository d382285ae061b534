import { answerForControl } from "../api/session";
import type { Finding } from "../api/types";
import { age } from "../parts/format";
import { CloseIcon } from "../parts/icons";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { useSilence } from "../state/freshness";
import { t } from "../state/language";
import { dismiss } from "../state/notices";
import { usePage } from "../state/router";
import { type Notice, useLive } from "../state/store";
import styles from "./Banners.module.css";

/** What must be read now: a lost connection, a lost device, a refusal, a stop. */
export function Banners() {
  const notice = useLive((s) => s.notice);
  const connection = useLive((s) => s.connection);
  const page = usePage();
  const onCard = useLive(
    (s) => page === "calibrate" && s.notice !== null && isOnCard(s.notice, s.flow?.findings ?? []),
  );
  return (
    <div className={styles.banners}>
      {connection !== "live" && <LostBanner first={connection === "connecting"} />}
      {connection === "live" && <LostDevices />}
      {connection === "live" && <ControlRequest />}
      {notice && !onCard && <NoticeBanner key={notice.id} notice={notice} />}
    </div>
  );
}

/** The card has the same text, with its remedy. */
function isOnCard({ title }: Notice, findings: readonly Finding[]): boolean {
  return findings.some(({ text }) => text === title);
}

function LostBanner({ first }: { first: boolean }) {
  const { silent_s } = useSilence();
  if (first && silent_s < 1) return null;
  return (
    <div className={styles.banner} data-quality="attention" role="status">
      <QualityMark quality="attention" />
      <div className={styles.words}>
        <strong>
          {first ? t("ui-connecting-to-the-station") : t("ui-connection-lost-reconnecting")},{" "}
          {age(Math.floor(silent_s))}
        </strong>
        {!first && <span>{t("ui-numbers-out-date-station-stores-everything")}</span>}
      </div>
    </div>
  );
}

/** Somebody requests control: displayed to whoever has it. */
function ControlRequest() {
  const requester = useLive((s) => s.control?.asked_by ?? null);
  const yours = useLive((s) => s.control?.holder?.id === s.session?.you?.id);
  if (!requester || !yours) return null;
  return (
    <div className={styles.banner} data-quality="neutral" role="alert">
      <QualityMark quality="neutral" />
      <div className={styles.words}>
        <strong>{t("ui-requests-control", { name: requester.name })}</strong>
        <span>{t("ui-running-jobs-continue-whoever-has-control")}</span>
      </div>
      <PressButton free onPress={async () => void (await answerForControl(true))}>
        {t("ui-give-control")}
      </PressButton>
      <PressButton free kind="quiet" onPress={async () => void (await answerForControl(false))}>
        {t("ui-keep-control")}
      </PressButton>
    </div>
  );
}

/** A device is called lost for as long as it is, and no longer. */
function LostDevices() {
  const devices = useLive((s) => s.devices);
  if (!devices) return null;
  const lost = [devices.arm, devices.sensor].filter(({ state }) => state === "lost");
  return lost.map(({ title, text }) => (
    <div key={title} className={styles.banner} data-quality="bad">
      <QualityMark quality="bad" />
      <div className={styles.words}>
        {/* the reason counts seconds, which nobody wants to have read out */}
        <strong role="alert">{t("ui-device-connection-lost", { device: title })}</strong>
        <span>{text}</span>
        <span>{t("ui-recorded-data-safe-check-power-cable")}</span>
      </div>
    </div>
  ));
}

function NoticeBanner({ notice }: { notice: Notice }) {
  return (
    <div className={styles.banner} data-quality={notice.quality} role={notice.quality === "bad" ? "alert" : "status"}>
      <QualityMark quality={notice.quality} />
      <div className={styles.words}>
        <strong>{notice.title}</strong>
        {notice.detail && <span>{notice.detail}</span>}
        {notice.remedy && <span className={styles.remedy}>{notice.remedy}</span>}
      </div>
      <button type="button" className={styles.close} aria-label={t("ui-dismiss")} onClick={() => dismiss(notice.id)}>
        <CloseIcon />
      </button>
    </div>
  );
}
