import { useState } from "react";

import { sendCommand, startPerformance } from "../api/guideCommands";
import type { LengthsPicture, PerformanceFile, PerformanceSummary, PerformanceView } from "../api/wire";
import { Layout } from "../frame/Layout";
import { Chips } from "../parts/Chips";
import { EmptyState } from "../parts/EmptyState";
import { moment } from "../parts/format";
import rows from "../parts/List.module.css";
import { PressButton } from "../parts/PressButton";
import { Reports } from "../parts/Reports";
import { t } from "../state/language";
import { go, useDetail } from "../state/router";
import { getState, useLive } from "../state/store";
import { useList } from "../state/useList";
import { useRead } from "../state/useRead";
import { ContactPictures } from "./contact/ContactPictures";
import { CertificateUpload } from "./exchange/CertificateUpload";
import { ExportFiles } from "./exchange/ExportFiles";
import { Verdict } from "./judgement/BigVerdict";
import { PerformanceRow } from "./judgement/PerformanceRow";
import { ResultTable } from "./judgement/ResultTable";
import { LengthErrors } from "./length/LengthErrors";
import { LengthPlaces } from "./length/LengthPlaces";
import styles from "./PerformancePage.module.css";
import { ArtefactChoice } from "./plan/ArtefactChoice";
import { GaugeDrawing } from "./plan/GaugeDrawing";
import { Temperatures } from "./plan/Temperatures";
import { PlateMap } from "./plane/PlateMap";
import { KINDS, type Kind } from "./session/kinds";
import { PerformanceCard } from "./session/PerformanceCard";
import { StartCard } from "./session/StartCard";
import { ArticulationList } from "./sphere/ArticulationList";
import { SphereMap } from "./sphere/SphereMap";

/** Arm and scanner against their datasheet: the guided test on a sphere, and the tests before. */
export function PerformancePage() {
  const view = useLive((s) => s.performance);
  const opened = useDetail();
  if (opened) return <Record id={opened} />;
  if (view?.running) return <Layout picture={<Picture view={view} />} card={<PerformanceCard view={view} />} />;
  return <Before />;
}

function Picture({ view }: { view: PerformanceView }) {
  const { picture, step } = view;
  if (step === "artefact") return <ArtefactChoice view={view} />;
  if (step === "review")
    return picture.result ? (
      <ResultTable result={picture.result}>{picture.lengths && <LengthErrors {...picture.lengths} />}</ResultTable>
    ) : (
      <EmptyState title="" text="" />
    );
  if (step === "temperatures")
    return (
      <div className={styles.temperatures}>
        <Temperatures view={view} end />
      </div>
    );
  if (picture.lengths) return <Lengths lengths={picture.lengths} busy={view.busy !== null} />;
  if (picture.contact) return <ContactPictures contact={picture.contact} step={step} />;
  const plate = view.test === "plane";
  return (
    <div className={styles.step}>
      {plate ? <PlateMap orientation={shownOrientation(picture)} /> : <SphereMap picture={picture} />}
      {picture.articulations.length > 0 && (
        <ArticulationList
          label={t(plate ? "ui-orientations" : "ui-articulations")}
          lines={picture.articulations}
          onRepeat={
            step !== "location" && view.busy === null
              ? (number) =>
                  void sendCommand("performance", "begin_scan", { [plate ? "orientation" : "articulation"]: number })
              : undefined
          }
        />
      )}
    </div>
  );
}

/** The orientation that is scanned now, or was last. */
function shownOrientation({ articulations }: PerformanceView["picture"]) {
  return articulations.find(({ state }) => state !== "done")?.number ?? articulations.length;
}

function Lengths({ lengths, busy }: { lengths: LengthsPicture; busy: boolean }) {
  const scanning = lengths.scans.some(({ state }) => state === "scanning");
  const [first] = lengths.scans;
  const scans = first && t("ui-scans-of-the-bar-in-place", { place: first.place });
  return (
    <div className={styles.step}>
      <div className={styles.drawings}>
        <LengthPlaces {...lengths} done={lengths.scanned ? "ui-done" : "ui-place-done"} />
        {scans && (
          <section className={styles.scans}>
            <h3 className={styles.name}>{scans}</h3>
            <ArticulationList
              label={scans}
              done="ui-scan-accepted"
              lines={lengths.scans}
              onRepeat={
                busy || scanning ? undefined : (repeat) => void sendCommand("performance", "begin_scan", { repeat })
              }
            />
          </section>
        )}
        <LengthErrors {...lengths} />
      </div>
      <ArticulationList
        label={t("ui-places")}
        lines={lengths.places.map((place) => ({
          ...place,
          text: place.scans > 0 ? t("ui-lengths-and-scans-done-of", place) : t("ui-lengths-done-of", place),
        }))}
      />
    </div>
  );
}

function Before() {
  const ended = useLive((s) => `${s.performance?.session_id ?? ""} ${s.performance?.running ?? ""}`);
  const { list } = useList<PerformanceSummary>("/api/performances", ended);
  const calibrated = useLive((s) => (s.home?.calibration ?? null) !== null);
  // the one that was done last is offered first
  const [test, setTest] = useState<PerformanceView["test"]>(() => getState().performance?.test ?? "sphere");
  const { title, about, needs } = KINDS[test];
  return (
    <Layout
      picture={
        list && list.length > 0 ? (
          <div className={styles.list}>
            <h2 className={styles.heading}>{t("ui-performance-tests")}</h2>
            <ul className={rows.list}>
              {list.map((summary) => (
                <PerformanceRow key={summary.id} summary={summary} />
              ))}
            </ul>
          </div>
        ) : (
          <EmptyState picture={<KindDrawing test={test} />} title={t("ui-performance-first-title")} text={t(about)} />
        )
      }
      card={
        <StartCard
          title={t(title)}
          text={t(needs)}
          calibrated={calibrated || !KINDS[test].scans}
          start={t("ui-start-the-test")}
          onStart={() => startPerformance(test)}
        >
          <Chips
            label={t("ui-kind-of-test")}
            options={(Object.keys(KINDS) as Kind[]).map((value) => ({ value, label: t(KINDS[value].label) }))}
            value={test}
            onChange={setTest}
          />
          {test === "sphere" && <CertificateUpload />}
        </StartCard>
      }
    />
  );
}

function KindDrawing({ test }: { test: Kind }) {
  if (test === "plane") return <GaugeDrawing shape="plane" scanning />;
  return test === "lengths" ? undefined : <GaugeDrawing shape="sphere" touching scanning={test === "sphere"} />;
}

function Record({ id }: { id: string }) {
  const { value: file, failed } = useRead<PerformanceFile>(`/api/performances/${id}`);
  return (
    <Layout
      picture={
        failed ? (
          <EmptyState title={t("ui-this-record-cannot-be-loaded")} text={t("ui-file-missing-data-folder-changed")} />
        ) : (
          file && (
            <ResultTable result={displayed(file)}>
              <LengthsOfRecord lengths={file.lengths ?? []} />
            </ResultTable>
          )
        )
      }
      card={
        <>
          {file && (
            <Verdict {...file.verdict}>
              <p>
                {namesOf(file)} · {moment(file.ended_at)}
              </p>
            </Verdict>
          )}
          <PressButton free onPress={() => go("performance")}>
            {t("ui-performance-tests")}
          </PressButton>
          <Reports of={`/api/performances/${id}`} />
          <ExportFiles id={id} />
        </>
      }
    />
  );
}

/** Of the artefacts that a test was done on. */
function namesOf({ sphere, length, plate }: PerformanceFile) {
  return [sphere, length, plate].flatMap((artefact) => (artefact ? [artefact.name] : [])).join(", ");
}

type LengthPoints = NonNullable<PerformanceFile["lengths"]>;

/** The errors by touch and those by scan, as far as there are. */
function LengthsOfRecord({ lengths }: { lengths: LengthPoints }) {
  const scanned = lengths.filter(({ by }) => by === "scan");
  const touched = lengths.filter(({ by }) => by !== "scan");
  return (
    (touched.length > 0 || scanned.length > 0) && (
      <LengthErrors touched={errorsOf(touched)} scanned={errorsOf(scanned)} />
    )
  );
}

function errorsOf(errors: LengthPoints) {
  return errors.length > 0 ? { errors, limits: limitsOf(errors) } : null;
}

/** The lengths of the standard, with the limits that they were judged by. */
function limitsOf(lengths: LengthPoints) {
  const limits = new Map(lengths.map(({ length_mm, limit_um }) => [length_mm, limit_um ?? null]));
  return [...limits]
    .map(([length_mm, limit_um]) => ({ length_mm, limit_um }))
    .sort((a, b) => a.length_mm - b.length_mm);
}

function displayed(file: PerformanceFile) {
  return {
    status: file.status ?? "",
    problems: file.problems ?? [],
    notes: file.notes ?? [],
    offset: file.offset?.text ?? "",
    figures: file.figures.map((figure) => ({
      ...figure,
      value: figure.value ?? null,
      values: figure.values ?? [],
      limit: figure.limit ?? null,
      test_uncertainty: figure.test_uncertainty ?? null,
      problem: figure.problem ?? "",
    })),
  };
}
