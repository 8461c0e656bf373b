import { isLanguage, LANGUAGES, SCREEN_LANGUAGES } from "../i18n/languages.ts";
import type { Settings } from "../app/base/settings/settings.ts";
import { editSettings } from "../app/document/edit-settings.ts";
import type { PartTexts } from "../i18n/parts.ts";

/** A setting of the page with its values. */
export interface SettingChoice {
  readonly id: string;
  readonly name: string;
  readonly value: string;
  readonly options: readonly { readonly value: string; readonly name: string; readonly lang?: string }[];
  readonly choose: (value: string) => void;
}

type Words<V extends string> = Readonly<Record<V, string>>;

export function choice<V extends string>(
  id: string,
  name: string,
  values: readonly V[],
  words: Words<V>,
  value: V,
  put: (value: V) => void,
): SettingChoice {
  return {
    id,
    name,
    value,
    options: values.map((each) => ({ value: each, name: words[each] })),
    choose(chosen) {
      const found = values.find((each) => each === chosen);
      if (found !== undefined) put(found);
    },
  };
}

/** The settings of the page, for their dialog and the command palette. */
export const settingChoices = (t: PartTexts<"first">["page"], settings: Settings): readonly SettingChoice[] => [
  {
    id: "language",
    name: t.screenLanguage,
    value: settings.language,
    options: LANGUAGES.map((language) => ({
      value: language,
      name: SCREEN_LANGUAGES[language].name,
      lang: language,
    })),
    choose: (language) => void (isLanguage(language) && editSettings({ language })),
  },
  choice(
    "theme",
    t.theme,
    ["system", "light", "dark"],
    t.themes,
    settings.theme,
    (theme) => void editSettings({ theme }),
  ),
  choice(
    "size",
    t.size,
    ["usual", "presentation"],
    t.sizes,
    settings.presentation ? "presentation" : "usual",
    (size) => void editSettings({ presentation: size === "presentation" }),
  ),
  choice(
    "motion",
    t.motion,
    ["system", "reduced"],
    t.motions,
    settings.motion,
    (motion) => void editSettings({ motion }),
  ),
  choice(
    "control",
    t.control,
    ["TNC 640", "TNC7"],
    t.controls,
    settings.control,
    (control) => void editSettings({ control }),
  ),
];
