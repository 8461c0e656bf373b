import { useState, type KeyboardEvent } from "react";
import type { ApproachDraft } from "../../program/approach-draft.ts";
import type { ApproachField, ApproachWord } from "../../program/approach-fields.ts";

/** What the keys of the control do at the open prompt. */
export interface PromptActions {
  readonly step: (by: number) => void;
  readonly goTo: (word: ApproachWord | null) => void;
  readonly noEntry: () => void;
  readonly finish: () => void;
  readonly cancel: () => void;
}

/** Which prompt of a block is open. */
export interface Prompts {
  /** Null at the end of the dialog. */
  readonly open: ApproachField | null;
  /** Counts up each time the open field should take the keyboard. */
  readonly focus: number;
  readonly actions: PromptActions;
  readonly onKeyDown: (event: KeyboardEvent) => void;
}

interface Opened {
  readonly word: ApproachWord | null;
  /** The text as it was when the prompt opened, for Escape. */
  readonly before: string;
  readonly focus: number;
}

/** Walks through the prompts of a block in their order. */
export function usePrompts(fields: readonly ApproachField[], draft: ApproachDraft, set: (words: ApproachDraft) => void): Prompts {
  const [opened, setOpened] = useState<Opened>({ word: fields[0]?.id ?? null, before: draft[fields[0]?.id ?? "X"] ?? "", focus: 0 });
  const open = opened.word === null ? null : (fields.find((f) => f.id === opened.word) ?? fields[0] ?? null);
  const goTo = (word: ApproachWord | null) => setOpened((o) => ({ word, before: word ? (draft[word] ?? "") : "", focus: o.focus + 1 }));
  const step = (by: number) => {
    const at = open ? fields.indexOf(open) : fields.length;
    if (at + by >= 0) goTo(fields[at + by]?.id ?? null);
  };
  const actions: PromptActions = {
    step, goTo,
    finish: () => goTo(null),
    noEntry() {
      if (!open?.optional) return;
      set({ [open.id]: "" });
      step(1);
    },
    cancel() {
      if (!open) return;
      set({ [open.id]: opened.before });
      goTo(open.id);
    },
  };
  return {
    open, focus: opened.focus, actions,
    onKeyDown(event) {
      if (event.ctrlKey || event.metaKey || event.altKey || event.nativeEvent.isComposing) return;
      const onButton = event.target instanceof HTMLButtonElement;
      let used = true;
      switch (event.key) {
        case "Enter":
          if (onButton) used = false;
          else step(1);
          break;
        case "ArrowDown": step(1); break;
        case "ArrowUp": step(-1); break;
        case "End": actions.finish(); break;
        case "Escape": actions.cancel(); break;
        case "Delete":
          if (open?.optional) actions.noEntry();
          else used = false;
          break;
        default: used = false;
      }
      if (!used) return;
      event.preventDefault();
      event.stopPropagation();
    },
  };
}
