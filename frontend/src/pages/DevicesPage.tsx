import { useState } from "react";

import { type Choice, chooseDevice, type DeviceKind, searchDevices, tryDevice } from "../api/deviceCommands";
import type { FoundView, TrialView } from "../api/wire";
import { CardHead } from "../controls/CardHead";
import { DeviceList } from "../devices/DeviceList";
import { DevicesCard } from "../devices/DevicesCard";
import { ManualCard } from "../devices/ManualCard";
import { driversOf, manualTitle } from "../devices/names";
import { TrialCard } from "../devices/TrialCard";
import { TrialPicture } from "../devices/TrialPicture";
import { useDevices, useTrial } from "../devices/useDevices";
import { Layout } from "../frame/Layout";
import { t } from "../state/language";
import { useLive } from "../state/store";

/** Finds cameras and arms, tries them, and takes them into use. */
export function DevicesPage() {
  const role = useLive((s) => s.session?.you?.role);
  if (role === "admin") return <Devices />;
  const text = role ? t("ui-only-an-administrator-can-connect-devices") : t("ui-waiting-for-the-station");
  return <Layout picture={null} card={<CardHead title={t("ui-devices")} text={text} />} />;
}

function Devices() {
  const [view, putView] = useDevices();
  const [choice, setChoice] = useState<Choice | null>(null);
  const [title, setTitle] = useState("");
  const [label, setLabel] = useState("");
  const [opened, setOpened] = useState<TrialView | null>(null);
  const [saved, setSaved] = useState<DeviceKind | null>(null);
  const trial = useTrial(opened !== null, opened);

  const back = () => {
    setOpened(null);
    setChoice(null);
  };
  const attempt = async (wanted: Choice) => {
    setSaved(null);
    setChoice(wanted);
    const now = await tryDevice(wanted);
    if (now) setOpened(now);
  };
  const tryFound = async ({ kind, driver, options, title: name, in_use }: FoundView) => {
    const used = in_use ? view?.devices.find((one) => one.kind === kind) : undefined;
    setTitle(name);
    setLabel(used?.label ?? "");
    await attempt({ kind, driver: used?.driver ?? driver, options: used?.options ?? options });
  };
  const enter = (kind: DeviceKind) => {
    const driver = (view && driversOf(view, kind)[0]?.name) ?? "";
    setTitle("");
    setLabel("");
    setSaved(null);
    setChoice({ kind, driver, options: {} });
  };
  const use = async () => {
    if (!choice) return;
    const now = await chooseDevice(choice, label);
    if (!now) return;
    putView(now);
    setSaved(choice.kind);
    back();
  };

  if (!view) {
    return <Layout picture={null} card={<CardHead title={t("ui-devices")} text={t("ui-waiting-for-the-station")} />} />;
  }
  if (choice && opened && trial) {
    return (
      <Layout
        picture={<TrialPicture trial={trial} />}
        card={
          <TrialCard
            trial={trial}
            title={title || trial.name || manualTitle(trial.kind)}
            view={view}
            choice={choice}
            label={label}
            onChoice={setChoice}
            onLabel={setLabel}
            onTry={() => attempt(choice)}
            onUse={use}
            onBack={back}
          />
        }
      />
    );
  }
  const search = async () => putView(await searchDevices());
  return (
    <Layout
      picture={<DeviceList view={view} onTry={tryFound} onManual={enter} />}
      card={
        choice && !title ? (
          <ManualCard view={view} choice={choice} onChoice={setChoice} onTry={() => attempt(choice)} onBack={back} />
        ) : (
          <DevicesCard view={view} saved={saved} onSearch={search} onView={putView} />
        )
      }
    />
  );
}
