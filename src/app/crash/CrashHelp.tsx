import { useState } from "react";
import { Icon } from "../Icon.tsx";
import { unkeptNames } from "../saving/keep.ts";
import { downloadWorks } from "../saving/rescue.ts";
import { useEditor } from "../store.ts";
import { saveEverything } from "../works/export-works.ts";
import { useDeviceTexts } from "../works/use-device-texts.ts";
import { ReportList } from "./ReportList.tsx";
import "../works/works.css";

/** What helps after a fault of the page: the work as a file, everything as a file, and the report to copy. */
export function CrashHelp() {
  const { here, reports } = useDeviceTexts();
  const [said, say] = useState("");
  const { job, program } = useEditor.getState();
  const work = job ?? program;
  const everything = async () => {
    try {
      const { works, files } = await saveEverything(unkeptNames());
      say(here.exported(works, files));
    } catch {
      say(here.notExported);
    }
  };
  return (
    <>
      <div className="bring-buttons">
        {work && (
          <button type="button" className="button" onClick={() => downloadWorks([work])}>
            <Icon name="download" /> {reports.work}
          </button>
        )}
        <button type="button" className="button" aria-label={here.exportLong} onClick={() => void everything()}>
          <Icon name="download" /> {here.exportAll}
        </button>
      </div>
      <p role="status">{said}</p>
      <ReportList open />
    </>
  );
}
