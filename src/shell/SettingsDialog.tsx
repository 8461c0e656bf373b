import { Suspense, useLayoutEffect, useRef } from "react";
import { LANGUAGES, SCREEN_LANGUAGES, isLanguage } from "../i18n/languages.ts";
import { showOwn } from "../app/place/place.ts";
import { lazyPart } from "../app/base/parts.ts";
import { useSettings } from "../app/base/settings/settings.ts";
import { SETTINGS } from "../app/document/documents.ts";
import { editSettings } from "../app/document/edit-settings.ts";
import { dialogOf } from "../app/document/history.ts";
import { fetchOfflineState } from "../features/offline/index.ts";
import { fetchThisDevice } from "../features/works/index.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";
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
  const first = useRef<HTMLSelectElement>(null);
  useLayoutEffect(() => {
    dialog.current?.showModal();
    first.current?.focus();
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
        <label>
          <span>{t.screenLanguage}</span>
          <select
            ref={first}
            className="select"
            value={settings.language}
            onChange={(e) => isLanguage(e.target.value) && void editSettings({ language: e.target.value })}
          >
            {LANGUAGES.map((language) => (
              <option key={language} value={language} lang={language}>
                {SCREEN_LANGUAGES[language].name}
              </option>
            ))}
          </select>
        </label>
        <label>
          <span>{t.theme}</span>
          <select
            className="select"
            value={settings.theme}
            onChange={(e) =>
              void editSettings({
                theme: e.target.value === "light" || e.target.value === "dark" ? e.target.value : "system",
              })
            }
          >
            <option value="system">{t.themes.system}</option>
            <option value="light">{t.themes.light}</option>
            <option value="dark">{t.themes.dark}</option>
          </select>
        </label>
        <label>
          <span>{t.size}</span>
          <select
            className="select"
            value={settings.presentation ? "presentation" : "usual"}
            onChange={(e) => void editSettings({ presentation: e.target.value === "presentation" })}
          >
            <option value="usual">{t.sizes.usual}</option>
            <option value="presentation">{t.sizes.presentation}</option>
          </select>
        </label>
        <label>
          <span>{t.motion}</span>
          <select
            className="select"
            value={settings.motion}
            onChange={(e) => void editSettings({ motion: e.target.value === "reduced" ? "reduced" : "system" })}
          >
            <option value="system">{t.motions.system}</option>
            <option value="reduced">{t.motions.reduced}</option>
          </select>
        </label>
        <label>
          <span>{t.control}</span>
          <select
            className="select"
            value={settings.control}
            onChange={(e) => void editSettings({ control: e.target.value === "TNC7" ? "TNC7" : "TNC 640" })}
          >
            <option value="TNC 640">{t.controls["TNC 640"]}</option>
            <option value="TNC7">{t.controls.TNC7}</option>
          </select>
        </label>
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
        <Suspense>
          <MachineSection />
        </Suspense>
        <Suspense>
          <ThisDevice onBringIn={() => dialog.current?.close()} />
        </Suspense>
        <Suspense>
          <OfflineState />
        </Suspense>
      </form>
    </dialog>
  );
}
