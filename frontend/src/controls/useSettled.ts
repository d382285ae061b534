import { useEffect, useState } from "react";

const TYPED_MS = 300;

/** The typed text after a pause: the station is not queried at each key. */
export function useSettled(typed: string): string {
  const [settled, setSettled] = useState(typed);
  useEffect(() => {
    const timer = setTimeout(() => setSettled(typed), TYPED_MS);
    return () => clearTimeout(timer);
  }, [typed]);
  return settled;
}
