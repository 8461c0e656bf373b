import { useEffect, useState } from "react";
import type { ToolFit } from "../../program/which-tool.ts";
import { useEditor } from "../store.ts";
import { fitsOf } from "./client.ts";
import { useOutcome } from "./outcome.ts";

/** Rest after the last change before all tools are tried, ms: it costs a plan per tool. */
const REST = 120;

/** What each tool can do on the open contour; null until it is known. Asked for only while someone looks. */
export function useFits(): readonly ToolFit[] | null {
  const newest = useOutcome((s) => s.newest);
  const [fits, setFits] = useState<readonly ToolFit[] | null>(null);
  useEffect(() => {
    const { job } = useEditor.getState();
    if (!newest || !job) return undefined;
    let gone = false;
    const timer = setTimeout(() => {
      void fitsOf(job, newest).then((found) => {
        if (!gone) setFits(found);
      });
    }, REST);
    return () => {
      gone = true;
      clearTimeout(timer);
    };
  }, [newest]);
  return fits;
}
