import { useState } from "react";
import { Icon } from "../Icon.tsx";
import { handedOn, useEditor } from "../store.ts";
import { useHandedTexts } from "./use-handed-texts.ts";
import { WorkTools } from "./WorkTools.tsx";
import "./handing.css";

/** Says that the open work runs with what it was handed on with, and leads to it. */
export function WorkBar() {
  const words = useHandedTexts();
  const tools = useEditor((s) => handedOn(s).tools);
  const control = useEditor((s) => handedOn(s).control);
  const [shown, show] = useState(false);
  if (!words) return null;
  return (
    <div className="work-bar" role="region" aria-label={words.ofWork}>
      <Icon name="insert" /> <span>{tools ? words.bar(tools.length) : words.barControl(control ?? "")}</span>
      <button type="button" className="button" onClick={() => show(true)}>{words.ofWork}</button>
      {shown && <WorkTools words={words} done={() => show(false)} />}
    </div>
  );
}
