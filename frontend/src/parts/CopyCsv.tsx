import { useState } from "react";

import { t } from "../state/language";
import { copyText, toCsv } from "./csv";
import { CheckIcon, CopyIcon } from "./icons";
import { PressButton } from "./PressButton";
import type { TableData } from "./table";

const TOLD_MS = 3000;

export function CopyCsv({ tables }: { tables: TableData[] }) {
  const [told, setTold] = useState<"" | "copied" | "failed">("");
  const copy = async () => {
    setTold((await copyText(toCsv(tables))) ? "copied" : "failed");
    setTimeout(() => setTold(""), TOLD_MS);
  };
  return (
    <PressButton free onPress={copy}>
      {told === "copied" ? <CheckIcon size="1.25rem" /> : <CopyIcon size="1.25rem" />}
      {{ "": t("Copy as CSV"), copied: t("Copied, in mm and µm"), failed: t("This browser does not let us copy") }[told]}
    </PressButton>
  );
}
