import type { BlockCertificateView } from "../api/wire";
import { measured } from "../controls/lengths";
import { uncertaintyDecimals } from "../controls/uncertainty";
import design from "../design/Design.module.css";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";

const INSTRUMENTS: Record<string, PlainId> = { calliper: "ui-calliper", micrometer: "ui-micrometer" };
const nameOf = (tool: string) => (INSTRUMENTS[tool] ? t(INSTRUMENTS[tool]) : tool);

/** Each face of the block with its uncertainty, and what was found of the instrument. */
export function CertificateResult({ made }: { made: BlockCertificateView }) {
  const expanded = (um: number) => measured(um, "µm", uncertaintyDecimals(um, "µm"));
  return (
    <div className={design.results} data-certificate>
      <table>
        <caption>{t("ui-faces-as-measured")}</caption>
        <thead>
          <tr>
            <th scope="col">{t("ui-face")}</th>
            <th scope="col">{t("ui-as-drawn")}</th>
            <th scope="col">{t("ui-as-measured")}</th>
            <th scope="col">{t("ui-expanded-uncertainty-k-2")}</th>
          </tr>
        </thead>
        <tbody>
          {made.faces.map(({ name, drawn_mm, measured_mm, expanded_um }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{measured(drawn_mm, "mm", 4)}</td>
              <td>{measured(measured_mm, "mm", 4)}</td>
              <td>{expanded(expanded_um)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <div className={design.notes}>
        {made.tools.map(({ name, value_mm, expanded_um }) => (
          <p key={name}>
            {t("ui-tool-was-found", {
              tool: nameOf(name),
              value: measured(value_mm, "mm", 4),
              known: expanded(expanded_um),
            })}
          </p>
        ))}
        {made.notes.map((note) => (
          <p key={note}>{note}</p>
        ))}
      </div>
    </div>
  );
}
