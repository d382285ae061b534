import { useEffect, useState } from "react";

/** A field's text: the server's, until it is typed over. */
export function useHeld(held: string) {
  const [text, setText] = useState(held);
  useEffect(() => setText(held), [held]);
  return { text, setText, changed: text !== held };
}
