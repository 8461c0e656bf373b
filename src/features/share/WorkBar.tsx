import { useState } from "react";
import type { HandedTexts } from "../../i18n/en/handed.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { bundleOf, useEditor } from "../../app/document/store.ts";
import { nameOfMachine } from "./machine-name.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { WorkTools } from "./WorkTools.tsx";
import "./share.css";

/** The most important difference of a work's settings, as a sentence. */
function barText(words: HandedTexts, tools: number | undefined, control: Control | undefined, machine = ""): string {
  if (tools !== undefined) return words.bar(tools);
  return control === undefined ? words.barMachine(nameOfMachine(words, machine)) : words.barControl(control);
}

/** Says that the open work runs with the settings it was shared with, and opens their dialog. */
export function WorkBar() {
  const words = useTextsOrNull("handed");
  const tools = useEditor((s) => bundleOf(s).tools);
  const control = useEditor((s) => bundleOf(s).control);
  const device = useSettings((s) => s.control);
  const machine = useEditor((s) => bundleOf(s).machine);
  const [shown, show] = useState(false);
  if (!words) return null;
  return (
    <div className="work-bar" role="region" aria-label={words.ofWork}>
      <Icon name="insert" />{" "}
      <span>{barText(words, tools?.length, control === device ? undefined : control, machine)}</span>
      <button type="button" className="button" onClick={() => show(true)}>
        {words.ofWork}
      </button>
      {shown && <WorkTools words={words} done={() => show(false)} />}
    </div>
  );
}
