import type { VerificationRecord } from "../api/verifyFiles";
import { EmptyState } from "../parts/EmptyState";
import { ResultTabs } from "./ResultTabs";
import { shownOfRecord } from "./shown";

/** A verification of before, looked at again. */
export function RecordView({ record, failed }: { record: VerificationRecord | null; failed: boolean }) {
  if (failed) return <EmptyState title="This record cannot be read" text="Its file is not in the data folder any more, or was changed." />;
  return record && <ResultTabs key={record.id} shown={shownOfRecord(record)} id={record.id} />;
}
