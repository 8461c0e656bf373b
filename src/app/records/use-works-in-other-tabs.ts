import { useEffect, useState } from "react";
import { restartable } from "../base/once.ts";
import { takeAnswer } from "../base/until-gone.ts";
import { refreshWorks } from "./keep.ts";
import { onChanged, worksInOtherTabs } from "./tab.ts";

/** A tab that deletes many works announces each: the list is read once it rests, ms. */
const REST = 50;
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
    const read = restartable();
    const stop = onChanged(() =>
      read.start(() => {
        ask();
        void refreshWorks();
      }, REST),
    );
    ask();
    return () => {
      end();
      stop();
      read.stop();
    };
  }, []);
  return works;
}
