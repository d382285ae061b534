import { type ReactNode, useRef } from "react";

import { PressButton } from "./PressButton";

interface FileChooserProps {
  /** Of the hidden field, for a label. */
  id: string;
  /** Kinds of files, as of HTML's `accept`; all kinds without it. */
  accept?: string;
  multiple?: boolean;
  /** As for PressButton. */
  free?: boolean;
  disabled?: boolean;
  onFiles: (files: FileList) => Promise<void>;
  children: ReactNode;
}

/** A button that asks for files of this computer. */
export function FileChooser({ id, accept, multiple, free, disabled, onFiles, children }: FileChooserProps) {
  const field = useRef<HTMLInputElement>(null);
  return (
    <>
      <input
        ref={field}
        id={id}
        type="file"
        accept={accept}
        multiple={multiple}
        hidden
        onChange={(event) => {
          const chosen = event.currentTarget;
          // the same file can be chosen once more after it was corrected
          if (chosen.files?.length) void onFiles(chosen.files).finally(() => (chosen.value = ""));
        }}
      />
      <PressButton free={free ?? false} disabled={disabled ?? false} onPress={() => field.current?.click()}>
        {children}
      </PressButton>
    </>
  );
}
