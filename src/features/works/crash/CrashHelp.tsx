import { useState } from "react";
import { Icon } from "../../../app/base/Icon.tsx";
import { downloadWorks } from "../../../app/records/rescue.ts";
import { openContent } from "../../../app/document/store.ts";
import { BackUpButton } from "../BackUpButton.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { ReportList } from "./ReportList.tsx";
import "../works.css";

/** Help after an error of the page: the work as a file, a backup, and the report to copy. */
export function CrashHelp() {
  const { reports } = useTexts("device");
  const [said, say] = useState("");
  const work = openContent();
  return (
    <>
      <div className="bring-buttons">
        {work && (
          <button type="button" className="button" onClick={() => downloadWorks([work])}>
            <Icon name="download" /> {reports.work}
          </button>
        )}
        <BackUpButton say={say} />
      </div>
      <p role="status">{said}</p>
      <ReportList open />
    </>
  );
}
