import type { ReactNode, RefObject } from "react";
import { Icon } from "../../../app/base/Icon.tsx";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

/** The frame of a form that asks for an operation: the way back, and the button that puts it into the program. */
export function OperationFrame({
  form,
  isUsable,
  onBack,
  onPut,
  children,
}: {
  readonly form: RefObject<HTMLFormElement | null>;
  /** False while an answer is missing. */
  readonly isUsable: boolean;
  readonly onBack: () => void;
  readonly onPut: () => void;
  readonly children: ReactNode;
}) {
  const t = useTexts().operations;
  return (
    <form
      className="operation-form"
      ref={form}
      onSubmit={(event) => {
        event.preventDefault();
        onPut();
      }}
    >
      <div className="operation-body">{children}</div>
      <footer className="operation-foot">
        <button type="button" className="button" onClick={onBack}>
          <Icon name="back" /> {t.back}
        </button>
        <button type="submit" className="button primary" disabled={!isUsable}>
          {t.put}
        </button>
      </footer>
    </form>
  );
}
