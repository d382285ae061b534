import { type RefObject, useEffect, useRef } from "react";

/** For a card's heading: a new step takes the focus, so that Enter presses nothing and Tab leads to its first act. */
export function useStepHeading(step: string): RefObject<HTMLHeadingElement | null> {
  const heading = useRef<HTMLHeadingElement>(null);
  const shown = useRef(step);
  useEffect(() => {
    if (shown.current === step) return;
    shown.current = step;
    heading.current?.focus({ preventScroll: true });
  }, [step]);
  return heading;
}
