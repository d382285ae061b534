import type { VerificationRecord } from "../api/verifyFiles";
import { EmptyState } from "../parts/EmptyState";
import { t } from "../state/language";
import { asSent } from "../state/spoken";
import { ResultTabs } from "./ResultTabs";
import { shownOfRecord } from "./shown";

/** A verification of before, looked at again. */
export function RecordView({ record, failed }: { record: VerificationRecord | null; failed: boolean }) {
  if (failed) return <EmptyState title={t("This record cannot be read")} text={t("Its file is not in the data folder any more, or was changed.")} />;
  return record && <ResultTabs key={record.id} shown={shownOfRecord(record)} sent={shownOfRecord(asSent(record))} id={record.id} />;
}
