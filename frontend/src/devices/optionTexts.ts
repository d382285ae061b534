import type { OptionField, OptionOffer } from "../api/wire";
import { figures } from "../controls/figures";
import { measured } from "../controls/lengths";
import { t } from "../state/language";

/** What a person needs to know to fill in an option, and what the open device offers for it. */
export function optionHelp({ help, unit }: OptionField, offer: OptionOffer | undefined): string {
  const texts = [help];
  if (offer?.bounds) {
    const [from, to] = offer.bounds.map((value) => {
      const decimals = Math.abs(value) < 10 && !Number.isInteger(value) ? 2 : 0;
      return unit ? measured(value, unit, decimals) : figures(value, decimals);
    });
    texts.push(t("ui-from-to", { from: from ?? "", to: to ?? "" }));
  }
  if (offer?.largest) texts.push(t("ui-option-at-most", { largest: offer.largest }));
  return texts.filter(Boolean).join(" · ");
}
