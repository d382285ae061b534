import { answerForControl } from "../api/session";
import type { DeviceState } from "../api/deviceTypes";
import type { Finding } from "../api/types";
import { CloseIcon } from "../parts/icons";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { age } from "../parts/format";
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
  const told = useLive((s) => page === "calibrate" && s.notice !== null && isTold(s.notice, s.flow?.findings ?? []));
  return (
    <div className={styles.banners}>
      {connection !== "live" && <LostBanner first={connection === "connecting"} />}
      {connection === "live" && <LostDevices />}
      {connection === "live" && <Asked />}
      {notice && !told && <NoticeBanner key={notice.id} notice={notice} />}
    </div>
  );
}

/** Whether the card says it whole, beside what to do: it is not told over it again. */
function isTold({ title }: Notice, findings: readonly Finding[]): boolean {
  const told = title.toLowerCase();
  return findings.some(({ text }) => text !== "" && told.startsWith(text.replace(/\.$/, "").toLowerCase()));
}

function LostBanner({ first }: { first: boolean }) {
  const { silent_s } = useSilence();
  if (first && silent_s < 1) return null;
  return (
    <div className={styles.banner} data-quality="attention" role="status">
      <QualityMark quality="attention" />
      <div className={styles.words}>
        <strong>
          {first ? t("Connecting to the station") : t("Connection lost, reconnecting")}, {age(Math.floor(silent_s))}
        </strong>
        {!first && <span>{t("The numbers here are old. The station keeps everything it has taken.")}</span>}
      </div>
    </div>
  );
}

/** Somebody would like to have control: told to whoever has it. */
function Asked() {
  const asked_by = useLive((s) => s.control?.asked_by ?? null);
  const yours = useLive((s) => s.control?.holder?.id === s.session?.you?.id);
  if (!asked_by || !yours) return null;
  return (
    <div className={styles.banner} data-quality="neutral" role="alert">
      <QualityMark quality="neutral" />
      <div className={styles.words}>
        <strong>{t("{name} asks for control", { name: asked_by.name })}</strong>
        <span>{t("What runs goes on, whoever has it.")}</span>
      </div>
      <PressButton free onPress={async () => void (await answerForControl(true))}>
        {t("Hand over")}
      </PressButton>
      <PressButton free kind="quiet" onPress={async () => void (await answerForControl(false))}>
        {t("Keep it")}
      </PressButton>
    </div>
  );
}

/** A device is called lost for as long as it is, and no longer. */
function LostDevices() {
  const arm = useLive((s) => lostWords(s.devices?.arm));
  const sensor = useLive((s) => lostWords(s.devices?.sensor));
  return [arm, sensor].map(
    (words) =>
      words && (
        <div key={words} className={styles.banner} data-quality="bad" role="alert">
          <QualityMark quality="bad" />
          <div className={styles.words}>
            <strong>{words}</strong>
            <span>{t("What was taken is kept. Check its power and cable; it is connected again by itself.")}</span>
          </div>
        </div>
      ),
  );
}

/** Without the seconds, which the status line counts and which end it in every language. */
function lostWords(device: DeviceState | undefined): string {
  return device?.state === "lost" ? device.text.replace(/,? \S+ \d+(\.\d)? s$/, "") : "";
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
      <button type="button" className={styles.close} aria-label={t("Dismiss")} onClick={() => dismiss(notice.id)}>
        <CloseIcon />
      </button>
    </div>
  );
}
