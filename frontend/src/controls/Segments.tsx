import { SegmentedControl } from "@mantine/core";

import styles from "./Segments.module.css";

interface SegmentsProps {
  label: string;
  options: { value: string; label: string }[];
  value: string;
  onChange: (value: string) => void;
  disabled?: boolean;
  /** Takes the full width. */
  wide?: boolean;
}

/** A choice of one among a few views, side by side. */
export function Segments({ label, options, value, onChange, disabled = false, wide = false }: SegmentsProps) {
  return (
    <SegmentedControl
      value={value}
      onChange={onChange}
      data={options}
      disabled={disabled}
      fullWidth={wide}
      size="md"
      radius="md"
      aria-label={label}
      classNames={{ root: styles.control ?? "", label: styles.tab ?? "", indicator: styles.indicator ?? "" }}
    />
  );
}
