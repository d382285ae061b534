import { useEffect, useState } from "react";

/** The text of a field: that of the station, until the user types. */
export function useSetting(current: string) {
  const [text, setText] = useState(current);
  useEffect(() => setText(current), [current]);
  return { text, setText, changed: text !== current };
}
