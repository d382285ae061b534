import type { FocusEvent, FormEvent } from "react";

interface Field {
  changed: boolean;
  valid: boolean;
}

/**
 * A form whose fields are set together: with the Enter key, with its button, or as soon as the focus
 * leaves it, since what stands in the fields counts, whichever button is pressed next.
 */
export function useFieldForm(fields: Field[], set: () => Promise<void>) {
  const changed = fields.some((field) => field.changed);
  const valid = fields.every((field) => field.valid);
  const onSubmit = (event: FormEvent) => {
    event.preventDefault();
    if (valid) void set();
  };
  const onBlur = ({ currentTarget, relatedTarget }: FocusEvent) => {
    if (changed && valid && !currentTarget.contains(relatedTarget)) void set();
  };
  return { changed, valid, form: { onSubmit, onBlur } };
}
