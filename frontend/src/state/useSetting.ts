import { useEffect, useState } from "react";

/** A field's text: the station's, until it is typed over. */
export function useSetting(current: string) {
  const [text, setText] = useState(current);
  useEffect(() => setText(current), [current]);
  return { text, setText, changed: text !== current };
}
