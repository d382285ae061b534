import { QualityMark } from "../controls/QualityMark";
import { BASE, type ProxyFault, proxyFault } from "../state/base";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./Banners.module.css";

type Missing = ProxyFault | "upgrade";

/** What a proxy between this browser and the station does not pass on; null if nothing is missing. */
export function useMissing(): Missing | null {
  const session = useLive((s) => s.session);
  const blocked = useLive((s) => s.liveBlocked);
  const fault = proxyFault(session?.address ?? "");
  // only who can change it needs to know of the scheme: everything else works
  if (fault && (fault !== "scheme" || session?.you?.role === "admin")) return fault;
  return blocked ? "upgrade" : null;
}

/** Says what a proxy does not pass on, and what to set. */
export function ProxyBanner({ missing }: { missing: Missing }) {
  const asked = useLive((s) => s.session?.address ?? "");
  const [title, remedy] = texts(missing, asked);
  return (
    <div className={styles.banner} data-quality="attention" role="alert">
      <QualityMark quality="attention" />
      <div className={styles.words}>
        <strong>{title}</strong>
        <span className={styles.remedy}>{remedy}</span>
      </div>
    </div>
  );
}

function texts(missing: Missing, asked: string): [string, string] {
  const path = BASE.pathname.replace(/\/$/, "");
  switch (missing) {
    case "host":
      return [t("ui-proxy-changes-host", { here: BASE.host, there: new URL(asked).host }), t("ui-proxy-pass-host")];
    case "scheme":
      return [t("ui-proxy-hides-scheme"), t("ui-proxy-pass-scheme")];
    case "sub-path":
      return [t("ui-proxy-hides-sub-path", { here: BASE.pathname }), t("ui-proxy-pass-sub-path", { path })];
    case "upgrade":
      return [t("ui-proxy-drops-upgrade"), t("ui-proxy-pass-upgrade")];
  }
}
