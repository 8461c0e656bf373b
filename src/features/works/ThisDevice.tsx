import { useEffect, useRef, useState } from "react";
import { ReportList } from "./crash/ReportList.tsx";
import { useReports } from "../../app/records/reports.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { askToPersist, storageState, type StorageState } from "../../app/base/persist.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { readBackup } from "../../app/records/pending-restore.ts";
import { BackUpButton } from "./BackUpButton.tsx";
import { sizeWords } from "./size-words.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import "./works.css";

/** The data of this device: whether they are persistent, their size, backup and restore, and the error reports. */
export function ThisDevice({ onBringIn }: { readonly onBringIn: () => void }) {
  const { here: t, reports } = useTexts("device");
  const language = useSettings((s) => s.language);
  const count = useReports((r) => r.list.length);
  const [state, setState] = useState<StorageState | null>(null);
  const [said, say] = useState("");
  const file = useRef<HTMLInputElement>(null);
  const look = () => void storageState().then(setState);
  useEffect(look, []);
  const ask = async () => {
    if (!(await askToPersist())) say(t.refused);
    look();
  };
  return (
    <section className="this-device" aria-labelledby="this-device">
      <h3 id="this-device">{t.title}</h3>
      <p className="small">
        {state?.persisted === true ? t.forGood : state?.persisted === false ? t.mayGo : state && t.unsure}{" "}
        {state?.used !== null && state?.quota !== null && state && (
          <span className="soft">{t.used(sizeWords(state.used, language), sizeWords(state.quota, language))}</span>
        )}
      </p>
      <div className="bring-buttons">
        {state?.persisted === false && (
          <button type="button" className="button" onClick={() => void ask()}>
            {t.ask}
          </button>
        )}
        <BackUpButton say={say} />
        <button
          type="button"
          className="button"
          aria-label={t.importLong}
          title={t.importLong}
          onClick={() => file.current?.click()}
        >
          <Icon name="add" /> {t.importAll}
        </button>
        <input
          ref={file}
          type="file"
          hidden
          accept=".zip,application/zip"
          onChange={(event) => {
            const [chosen] = event.currentTarget.files ?? [];
            event.currentTarget.value = "";
            if (!chosen) return;
            onBringIn();
            void readBackup(chosen);
          }}
        />
      </div>
      <p role="status" className="small">
        {said}
      </p>
      {count > 0 && (
        <details>
          <summary>{`${reports.title} (${count})`}</summary>
          <ReportList />
        </details>
      )}
    </section>
  );
}
