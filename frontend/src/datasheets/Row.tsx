import { useState } from "react";

import { fileOf } from "../api/datasheetCommands";
import type { Action, DatasheetRow } from "../api/wire";
import { Download } from "../controls/Download";
import { days, daysAgo, moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { Question } from "../controls/Question";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./Datasheets.module.css";
import { isForm } from "./forms";

interface RowProps {
  row: DatasheetRow;
  saved: boolean;
  onEdit: (row: DatasheetRow) => void;
  onCopy: (row: DatasheetRow) => void;
  onCertify: (row: DatasheetRow) => void;
  onRetire: (row: DatasheetRow) => Promise<void>;
  onRestore: (row: DatasheetRow) => Promise<void>;
}

/** One datasheet: what it is of, since when, when it was used, and what can be done with it. */
export function Row({ row, saved, onEdit, onCopy, onCertify, onRetire, onRestore }: RowProps) {
  const { retired, problem, note, file, name, connected, in_use, last_use } = row;
  const hasForm = isForm(row.form) && file.endsWith(".json");
  return (
    <li className={`${rows.row} ${styles.row}`} data-saved={saved || undefined} data-retired={retired || undefined}>
      {problem && <QualityMark quality="attention" size="1.5rem" />}
      <div className={styles.what}>
        <p className={rows.name}>
          {isolated(name || file)}
          {connected && <span className={rows.badge}>{t("ui-connected-badge")}</span>}
          {in_use.length > 0 && (
            <span className={rows.badge}>{t("ui-in-use-by", { names: in_use.map(isolated).join(", ") })}</span>
          )}
        </p>
        <p className={rows.detail}>{details(row).join(" · ")}</p>
        {last_use && (
          <p className={`${rows.detail} ${styles.result}`}>
            <QualityMark quality={last_use.quality} size="1.125rem" />
            {t("ui-last-used", { at: moment(last_use.at), result: last_use.text })}
          </p>
        )}
        {problem && <p className={styles.problem}>{problem}</p>}
        {note && <p className={styles.notice}>{note}</p>}
      </div>
      <div className={styles.acts}>
        {hasForm && !retired && <PressButton onPress={() => onEdit(row)}>{t("ui-edit")}</PressButton>}
        {hasForm && <PressButton onPress={() => onCopy(row)}>{t("ui-copy")}</PressButton>}
        {row.form === "block" && !retired && (
          <PressButton free onPress={() => onCertify(row)}>
            {t("ui-certify")}
          </PressButton>
        )}
        <Download href={fileOf(row)}>{t("ui-file")}</Download>
        {retired ? (
          <PressButton kind="quiet" onPress={() => onRestore(row)}>
            {t("ui-bring-back")}
          </PressButton>
        ) : (
          <Retire row={row} onRetire={onRetire} />
        )}
      </div>
    </li>
  );
}

function details(row: DatasheetRow): string[] {
  const { serial_number, certificate, issued_on, valid_until, since, last_use, file, problem } = row;
  const age = -daysUntil(since);
  return [
    serial_number && t("ui-serial-of", { serial: serial_number }),
    certificate && t("ui-certificate-of", { certificate }),
    issued_on ? issue(issued_on) : certificate && t("ui-issue-date-unknown"),
    valid_until && validity(valid_until),
    t("ui-since", { when: age < 1 ? moment(since) : `${moment(since)} (${daysAgo(age)})` }),
    !problem && !last_use && t("ui-use-is-unknown"),
    file,
  ].filter((part) => typeof part === "string" && part !== "") as string[];
}

const DAY_MS = 86_400_000;
const daysUntil = (day: string) => (new Date(day).getTime() - Date.now()) / DAY_MS;

/** When a certificate was issued, and how old it is. */
function issue(day: string): string {
  const age = -daysUntil(day);
  return age < 0 ? t("ui-issued-on", { day }) : t("ui-issued-on-with-age", { day, age: daysAgo(age) });
}

/** Until when a certificate holds, or that it is over. */
function validity(day: string): string {
  const left = daysUntil(day) + 1; // the last day is one of them
  if (Number.isNaN(left)) return t("ui-valid-until", { day });
  return left < 0 ? t("ui-expired-on", { day }) : t("ui-valid-until-left", { day, left: days(left) });
}

function Retire({ row, onRetire }: { row: DatasheetRow; onRetire: RowProps["onRetire"] }) {
  const [asking, setAsking] = useState(false);
  const retire: Action = {
    name: "retire",
    label: t("ui-retire"),
    args: {},
    primary: false,
    enabled: true,
    why_not: "",
    confirm: t("ui-retire-it", { name: row.name || row.file }),
  };
  return (
    <>
      <PressButton kind="quiet" onPress={() => setAsking(true)}>
        {t("ui-retire")}
      </PressButton>
      <Question
        action={retire}
        no={t("ui-no-keep-it")}
        opened={asking}
        onClose={() => setAsking(false)}
        onAct={() => onRetire(row)}
      />
    </>
  );
}
