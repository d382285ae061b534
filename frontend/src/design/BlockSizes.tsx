import fieldLook from "../controls/Field.module.css";
import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import { MERLONS, NO_SIZES, SIZE_NAMES, SIZES, type SizeFields } from "./blockSizes";
import { Choice } from "./Choice";
import { NumberSlider } from "./NumberSlider";

interface BlockSizesProps {
  fields: SizeFields;
  /** Of the block that was designed last. */
  proposed: SizeFields;
  onFields: (fields: SizeFields) => void;
}

/** Sizes of the block that the design keeps. */
export function BlockSizes({ fields, proposed, onFields }: BlockSizesProps) {
  const isGiven = Object.values(fields).some(Boolean);
  return (
    <>
      <p className={fieldLook.help}>{t("ui-empty-sizes-are-proposed")}</p>
      {SIZE_NAMES.map((key) => {
        const { label, ...range } = SIZES[key];
        return (
          <NumberSlider
            key={key}
            {...range}
            label={t(label)}
            value={fields[key]}
            proposed={proposed[key]}
            onText={(text) => onFields({ ...fields, [key]: text })}
          />
        );
      })}
      <Choice
        label={t("ui-number-of-merlons")}
        value={fields.merlons}
        options={[
          { value: "", label: t("ui-as-proposed") },
          ...MERLONS.map((count) => ({ value: String(count), label: String(count) })),
        ]}
        onChange={(merlons) => onFields({ ...fields, merlons })}
      />
      {isGiven && (
        <PressButton free kind="quiet" onPress={() => onFields(NO_SIZES)}>
          {t("ui-propose-every-size")}
        </PressButton>
      )}
    </>
  );
}
