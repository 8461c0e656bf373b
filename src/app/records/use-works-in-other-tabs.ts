import { useEffect, useState } from "react";
import { refreshWorks } from "./keep.ts";
import { onChanged, worksInOtherTabs } from "./tab.ts";

const NONE: ReadonlySet<string> = new Set();

/** Works open in other tabs, kept up to date while a list is shown. Changes there re-read the list. */
export function useWorksInOtherTabs(): ReadonlySet<string> {
  const [works, set] = useState(NONE);
  useEffect(() => {
    let gone = false;
    const ask = () => void worksInOtherTabs().then((found) => !gone && set(found.size > 0 ? found : NONE));
    const stop = onChanged(() => {
      ask();
      void refreshWorks();
    });
    ask();
    return () => {
      gone = true;
      stop();
    };
  }, []);
  return works;
}
