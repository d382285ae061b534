import { useEffect, useState } from "react";

import { get } from "../api/http";

/** A file of the server, read once per address; null until it has been read. */
export function useFile<T>(path: string, change = ""): { file: T | null; failed: boolean } {
  const [read, setRead] = useState<{ path: string; file: T | null; failed: boolean }>({
    path: "",
    file: null,
    failed: false,
  });
  // biome-ignore lint/correctness/useExhaustiveDependencies: reloaded with each change
  useEffect(() => {
    if (!path) return;
    let wanted = true;
    get<T>(path).then(
      (file) => wanted && setRead({ path, file, failed: false }),
      () => wanted && setRead({ path, file: null, failed: true }),
    );
    return () => {
      wanted = false;
    };
  }, [path, change]);
  return read.path === path ? read : { file: null, failed: false };
}
