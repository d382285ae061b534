import { useState } from "react";

import { t } from "../state/language";
import { copyText, toCsv } from "./csv";
import { CheckIcon, CopyIcon } from "./icons";
import { PressButton } from "./PressButton";
import type { TableData } from "./table";

const DISPLAY_MS = 3000;

export function CopyCsv({ tables }: { tables: TableData[] }) {
  const [result, setResult] = useState<"" | "copied" | "failed">("");
  const copy = async () => {
    setResult((await copyText(toCsv(tables))) ? "copied" : "failed");
    setTimeout(() => setResult(""), DISPLAY_MS);
  };
  return (
    <PressButton free onPress={copy}>
      {result === "copied" ? <CheckIcon size="1.25rem" /> : <CopyIcon size="1.25rem" />}
      {
        {
          "": t("ui-copy-as-csv"),
          copied: t("ui-copied-in-mm-and-m"),
          failed: t("ui-this-browser-does-not-allow-copying"),
        }[result]
      }
    </PressButton>
  );
}
