import { type ComponentType, lazy } from "react";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { PressButton } from "../controls/PressButton";
import { Layout } from "../frame/Layout";
import { t } from "../state/language";

/** All pages but the first one travel after it. */
const LOADS = {
  calibrate: async () => (await import("./CalibratePage")).CalibratePage,
  verify: async () => (await import("../gauges/quick/VerifyPage")).VerifyPage,
  performance: async () => (await import("../gauges/PerformancePage")).PerformancePage,
  part: async () => (await import("../parts/PartPage")).PartPage,
  scan: async () => (await import("./ScanPage")).ScanPage,
  arm: async () => (await import("./ArmPage")).ArmPage,
  records: async () => (await import("./RecordsPage")).RecordsPage,
  supervise: async () => (await import("./SupervisePage")).SupervisePage,
  health: async () => (await import("./HealthPage")).HealthPage,
  settings: async () => (await import("./SettingsPage")).SettingsPage,
  datasheets: async () => (await import("./DatasheetsPage")).DatasheetsPage,
  devices: async () => (await import("./DevicesPage")).DevicesPage,
  people: async () => (await import("./PeoplePage")).PeoplePage,
  docs: async () => (await import("./ReferencePage")).ReferencePage,
};

function later(load: () => Promise<ComponentType>) {
  return lazy(async () => {
    try {
      return { default: await load() };
    } catch {
      return { default: NotLoaded };
    }
  });
}

export const LATER_PAGES = {
  calibrate: later(LOADS.calibrate),
  verify: later(LOADS.verify),
  performance: later(LOADS.performance),
  part: later(LOADS.part),
  scan: later(LOADS.scan),
  arm: later(LOADS.arm),
  records: later(LOADS.records),
  supervise: later(LOADS.supervise),
  health: later(LOADS.health),
  settings: later(LOADS.settings),
  datasheets: later(LOADS.datasheets),
  devices: later(LOADS.devices),
  people: later(LOADS.people),
  docs: later(LOADS.docs),
};

/** Once the first page stands, the others are fetched: they open also while the station is away.
 *  One after the other, as a proxy limits how many requests are open at once. */
export async function preloadPages(): Promise<void> {
  for (const load of Object.values(LOADS)) await load().catch(() => undefined);
}

/** The station did not send the page, or it is another version by now. */
function NotLoaded() {
  return (
    <Layout
      picture={null}
      card={
        <>
          <CardHead title={t("ui-the-page-did-not-load")} text={t("ui-the-page-did-not-load-why")} />
          <MainAct>
            <PressButton free kind="primary" onPress={() => window.location.reload()}>
              {t("ui-load-again")}
            </PressButton>
          </MainAct>
        </>
      }
    />
  );
}
