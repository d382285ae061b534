import { type RefObject, useEffect, useRef } from "react";

/** For the heading of a card: a new step takes the focus, so that Enter presses nothing and Tab goes to the first action. */
export function useStepHeading(step: string): RefObject<HTMLHeadingElement | null> {
  const heading = useRef<HTMLHeadingElement>(null);
  const current = useRef(step);
  useEffect(() => {
    if (current.current === step) return;
    current.current = step;
    heading.current?.focus({ preventScroll: true });
  }, [step]);
  return heading;
}
