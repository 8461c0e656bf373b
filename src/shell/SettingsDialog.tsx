import { useLayoutEffect, useRef } from "react";
import { showOwn } from "../app/place/place.ts";
import { lazyPart } from "../app/base/parts.ts";
import { useSettings } from "../app/base/settings/settings.ts";
import { SETTINGS } from "../app/document/documents.ts";
import { dialogOf } from "../app/document/history.ts";
import { fetchOfflineState } from "../features/offline/index.ts";
import { fetchThisDevice } from "../features/works/index.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { settingChoices } from "./setting-choices.ts";
import { UndoButtons } from "./UndoButtons.tsx";

const MachineSection = lazyPart(async () => ({
  default: (await import("../app/fields/machine/MachineSection.tsx")).MachineSection,
}));
const OfflineState = lazyPart(async () => ({ default: (await fetchOfflineState()).OfflineState }));
const ThisDevice = lazyPart(async () => ({ default: (await fetchThisDevice()).ThisDevice }));

/** Language, appearance, motion and machine: choices of this device. */
export function SettingsDialog({ onClose }: { readonly onClose: () => void }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const t = useTexts("first").page;
  const settings = useSettings();
  useLayoutEffect(() => {
    dialog.current?.showModal();
    dialog.current?.querySelector("select")?.focus();
  }, []);
  return (
    <dialog
      ref={dialog}
      className="settings"
      {...dialogOf(SETTINGS)}
      aria-label={t.settings}
      onClose={onClose}
      onClick={(e) => e.target === e.currentTarget && dialog.current?.close()}
    >
      <form method="dialog">
        <div className="settings-head">
          <h2>{t.settings}</h2>
          <div className="settings-head-buttons">
            <UndoButtons document={SETTINGS} />
            <button type="submit" className="button primary">
              {t.close}
            </button>
          </div>
        </div>
        {settingChoices(t, settings).map(({ name, value, options, choose }) => (
          <label key={name}>
            <span>{name}</span>
            <select className="select" value={value} onChange={(e) => choose(e.target.value)}>
              {options.map((option) => (
                <option key={option.value} value={option.value} lang={option.lang}>
                  {option.name}
                </option>
              ))}
            </select>
          </label>
        ))}
        <button
          type="button"
          className="button"
          onClick={() => {
            dialog.current?.close();
            showOwn();
          }}
        >
          {t.own.title}
        </button>
        <p className="small soft">{t.disclaimer}</p>
        <p className="small soft">Turnwise {import.meta.env.VITE_VERSION}</p>
        <MachineSection />
        <ThisDevice onBringIn={() => dialog.current?.close()} />
        <OfflineState />
      </form>
    </dialog>
  );
}
