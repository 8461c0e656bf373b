import { useRef, useState, type RefObject } from "react";
import { learnerOfDevice, noteLearner, type Learner } from "../../../app/records/course/learner.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";
import { TeachText } from "./WordFields.tsx";

/** Name and class of the learner, as they are typed. */
export interface LearnerEntry {
  readonly learner: Learner;
  readonly change: (some: Partial<Learner>) => void;
  /** A name was asked for and is missing. */
  readonly isMissing: boolean;
  readonly fields: RefObject<HTMLDivElement | null>;
  /** Remembers the learner on the device; without a name, asks for it and returns false. */
  readonly confirm: () => boolean;
}

/** The learner of this device, or of `first`, until typed otherwise. */
export function useLearnerEntry(isNeeded: boolean, first: Learner = learnerOfDevice()): LearnerEntry {
  const [learner, put] = useState(first);
  const [isAsked, ask] = useState(false);
  const fields = useRef<HTMLDivElement>(null);
  const lacks = isNeeded && learner.name.trim() === "";
  return {
    learner,
    change: (some) => put((now) => ({ ...now, ...some })),
    isMissing: isAsked && lacks,
    fields,
    confirm: () => {
      ask(lacks);
      if (lacks) fields.current?.querySelector("input")?.focus();
      else noteLearner(learner);
      return !lacks;
    },
  };
}

/** The fields of name and class. */
export function LearnerFields({ entry, optional }: { readonly entry: LearnerEntry; readonly optional: boolean }) {
  const t = useTexts("course-teach"),
    words = useTexts("course-set");
  const { learner, change, isMissing, fields } = entry;
  return (
    <div ref={fields} className="teach-pairs">
      <TeachText
        label={optional ? t.hand.name : words.paper.name}
        value={learner.name}
        change={(name) => change({ name })}
      />
      <TeachText label={words.group} value={learner.group} change={(group) => change({ group })} />
      {isMissing && (
        <Message tone="warning" role="alert">
          {words.exam.noName}
        </Message>
      )}
    </div>
  );
}
