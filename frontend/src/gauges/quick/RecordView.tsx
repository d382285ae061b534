import type { VerificationFile } from "../../api/wire";
import { EmptyState } from "../../parts/EmptyState";
import { t } from "../../state/language";
import { asSent } from "../../state/localized";
import { ResultTabs } from "./ResultTabs";
import { displayedRecord } from "./verification";

/** An earlier verification. */
export function RecordView({ record, failed }: { record: VerificationFile | null; failed: boolean }) {
  if (failed)
    return <EmptyState title={t("ui-this-record-cannot-be-loaded")} text={t("ui-file-missing-data-folder-changed")} />;
  return (
    record && (
      <ResultTabs
        key={record.id}
        displayed={displayedRecord(record)}
        sent={displayedRecord(asSent(record))}
        id={record.id}
      />
    )
  );
}
