import { answerForControl } from "../api/session";
import type { Finding } from "../api/wire";
import { age } from "../controls/format";
import { CloseIcon } from "../controls/icons";
import { measured } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { TourBanner } from "../guidance/TourBanner";
import { dismiss } from "../state/banner";
import { useBarred, useOnlyViews } from "../state/control";
import { stopDemonstration } from "../state/demonstration";
import { useSilence } from "../state/freshness";
import { t } from "../state/language";
import { go, type Page, usePage } from "../state/router";
import { type BannerMessage, useLive } from "../state/store";
import styles from "./Banners.module.css";
import { ProxyBanner, useMissing } from "./ProxyBanner";

/** Urgent messages: a lost connection, a lost device, a refusal, a stop. */
export function Banners() {
  const banner = useLive((s) => s.banner);
  const connection = useLive((s) => s.connection);
  const page = usePage();
  const missing = useMissing();
  const onCard = useLive(
    (s) => page === "calibrate" && s.banner !== null && isOnCard(s.banner, s.flow?.findings ?? []),
  );
  return (
    <div className={styles.banners}>
      {missing && <ProxyBanner missing={missing} />}
      {!missing && connection !== "live" && <LostBanner first={connection === "connecting"} />}
      {connection === "live" && <LostDevices />}
      {connection === "live" && <DemonstrationBanner />}
      {connection === "live" && <ControlRequest />}
      {connection === "live" && <ArmNote />}
      {connection === "live" && WITHOUT_MAIN_ACT.has(page) && <BarredNote />}
      <TourBanner />
      {banner && !onCard && <MessageBanner key={banner.id} banner={banner} />}
    </div>
  );
}

/** Pages on which no large button says why nothing can be pressed. */
const WITHOUT_MAIN_ACT: ReadonlySet<Page> = new Set([
  "home",
  "records",
  "health",
  "settings",
  "datasheets",
  "devices",
  "people",
]);

/** Why the buttons of the page are disabled: by another browser's control, or by the role. */
function BarredNote() {
  const barred = useBarred();
  const theirs = useLive((s) => s.control?.holder != null && s.control.holder.id !== s.session?.you?.id);
  const views = useOnlyViews() !== "";
  if (!barred) return null;
  return (
    <div className={styles.banner} data-quality="neutral" role="status">
      <QualityMark quality="neutral" />
      <div className={styles.words}>
        <strong>{barred}</strong>
        <span>{t("ui-buttons-that-change-something-are-disabled")}</span>
        {theirs && !views && <span className={styles.remedy}>{t("ui-request-it-under-control")}</span>}
      </div>
    </div>
  );
}

/** The card has the same text, with its remedy. */
function isOnCard({ title }: BannerMessage, findings: readonly Finding[]): boolean {
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

/** What the demonstration does now, and how long until it decides; anyone can stop it. */
function DemonstrationBanner() {
  const demonstration = useLive((s) => s.demonstration);
  const page = usePage();
  if (!demonstration?.running) return null;
  const { text, decides_in_s, page: shown } = demonstration;
  return (
    <div className={styles.banner} data-quality="neutral">
      {decides_in_s !== null && (
        <span className={styles.count} role="timer">
          {measured(decides_in_s, "s")}
        </span>
      )}
      <div className={styles.words} role="status">
        <strong>{t("ui-demonstration")}</strong>
        <span>{text}</span>
      </div>
      {page !== shown && (
        <PressButton free kind="quiet" onPress={() => go(shown)}>
          {t("ui-show-it")}
        </PressButton>
      )}
      <PressButton free onPress={stopDemonstration}>
        {t("ui-stop-the-demonstration")}
      </PressButton>
    </div>
  );
}

/** A request for control, shown to the user who has it. */
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

/** What the station stopped by itself, until the next activity begins. */
function ArmNote() {
  const note = useLive((s) => s.activity?.note ?? null);
  if (!note) return null;
  return (
    <div className={styles.banner} data-quality={note.quality} role="alert">
      <QualityMark quality={note.quality} />
      <div className={styles.words}>
        <strong>{note.text}</strong>
        <span className={styles.remedy}>{note.remedy}</span>
      </div>
    </div>
  );
}

/** A device is shown as lost only while it is lost. */
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

function MessageBanner({ banner }: { banner: BannerMessage }) {
  return (
    <div className={styles.banner} data-quality={banner.quality} role={banner.quality === "bad" ? "alert" : "status"}>
      <QualityMark quality={banner.quality} />
      <div className={styles.words}>
        <strong>{banner.title}</strong>
        {banner.detail && <span>{banner.detail}</span>}
        {banner.remedy && <span className={styles.remedy}>{banner.remedy}</span>}
      </div>
      <button type="button" className={styles.close} aria-label={t("ui-dismiss")} onClick={() => dismiss(banner.id)}>
        <CloseIcon />
      </button>
    </div>
  );
}
