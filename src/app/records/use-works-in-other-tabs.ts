import { useEffect, useState } from "react";
import { takeAnswer } from "../base/until-gone.ts";
import { refreshWorks } from "./keep.ts";
import { onChanged, worksInOtherTabs } from "./tab.ts";

const NONE: ReadonlySet<string> = new Set();

/** Works open in other tabs, kept up to date while a list is shown. Changes there re-read the list. */
export function useWorksInOtherTabs(): ReadonlySet<string> {
  const [works, set] = useState(NONE);
  useEffect(() => {
    let end = () => undefined as void;
    const ask = () => {
      end();
      end = takeAnswer(worksInOtherTabs, (found) => set(found.size > 0 ? found : NONE));
    };
    const stop = onChanged(() => {
      ask();
      void refreshWorks();
    });
    ask();
    return () => {
      end();
      stop();
    };
  }, []);
  return works;
}
