import { useState } from "react";
import type { NamedQuantity } from "../api/wire";
import { t } from "../state/language";

/** The chosen one of some quantities: `first` if it is there; empty without any. */
export function useQuantity(known: NamedQuantity[], first: string): [string, (id: string) => void] {
  return useState(known.some(({ id }) => id === first) ? first : (known[0]?.id ?? ""));
}

/** A choice of a quantity, in words with its unit. */
export function ChooseQuantity({
  known,
  value,
  onChange,
}: {
  known: NamedQuantity[];
  value: string;
  onChange: (id: string) => void;
}) {
  return (
    <label>
      {t("ui-fleet-quantity")}
      <select value={value} onChange={(event) => onChange(event.target.value)}>
        {known.map(({ id, title, unit }) => (
          <option key={id} value={id}>
            {unit ? `${title}, ${unit}` : title}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The words of a quantity; one that is unknown is called by its id. */
export function quantityName(known: NamedQuantity[], id: string): string {
  return known.find((one) => one.id === id)?.title ?? id;
}
