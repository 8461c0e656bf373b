import { useEffect, useRef, useState } from "react";
import { lazyPart } from "../../base/parts.ts";
import { holds } from "../../base/use-media.ts";
import { numberFieldOf } from "./field-typing.ts";

const FieldKeypad = lazyPart(async () => ({ default: (await import("./FieldKeypad.tsx")).FieldKeypad }));

/**
 * Shows the keypad for every number field (an input with `data-number`) on touch, and suppresses the device keyboard,
 * which would cover the picture. Fields for names keep that keyboard.
 */
export function NumberKeys() {
  const [field, setField] = useState<HTMLInputElement | null>(null);
  /** The last press was by a finger or a pen. */
  const touched = useRef(false);
  /** The field that just got the focus. */
  const fresh = useRef<HTMLInputElement | null>(null);
  /** The field that uses the device keyboard. */
  const spelled = useRef<HTMLInputElement | null>(null);

  useEffect(() => {
    const onPress = (e: PointerEvent) => {
      touched.current = e.pointerType !== "mouse";
      const pressed = numberFieldOf(e.target);
      if (pressed && touched.current && spelled.current !== pressed) pressed.inputMode = "none";
    };
    const openFor = (target: EventTarget | null) => {
      const focused = numberFieldOf(target),
        fits = focused !== null && (touched.current || holds("coarse"));
      if (fits && spelled.current !== focused) {
        focused.inputMode = "none";
        fresh.current = focused;
        setField(focused);
      }
    };
    const onFocus = (e: FocusEvent) => openFor(e.target);
    // As in the prompts, the first digit replaces the value; the next tap sets the caret. The field may have moved
    // under the finger when its keypad opened.
    const onClick = () => {
      if (fresh.current !== null && fresh.current === document.activeElement) fresh.current.select();
      fresh.current = null;
    };
    // If a key is the first click after that, it replaces the old text. Selecting after it would let the next digit
    // replace its own.
    const onKey = ({ target }: MouseEvent) => {
      if (target instanceof Element && target.closest(".field-keypad")) onClick();
    };
    // A removed field does not always blur first. The page moves when the keypad closes, so that waits until the tap
    // that moved the focus has hit its target.
    const onLeave = () =>
      requestAnimationFrame(() => {
        if (spelled.current && document.activeElement !== spelled.current) {
          spelled.current.inputMode = "none";
          spelled.current = null;
        }
        setField((open) => (open !== null && document.activeElement === open ? open : null));
      });
    document.addEventListener("pointerdown", onPress, true);
    document.addEventListener("focusin", onFocus);
    document.addEventListener("click", onKey, true);
    document.addEventListener("click", onClick);
    document.addEventListener("focusout", onLeave);
    document.addEventListener("pointerup", onLeave);
    // This part is fetched: a field may have got the focus before.
    openFor(document.activeElement);
    return () => {
      document.removeEventListener("pointerdown", onPress, true);
      document.removeEventListener("focusin", onFocus);
      document.removeEventListener("click", onKey, true);
      document.removeEventListener("click", onClick);
      document.removeEventListener("focusout", onLeave);
      document.removeEventListener("pointerup", onLeave);
    };
  }, []);

  if (!field) return null;
  return (
    <FieldKeypad
      field={field}
      onLetters={(open) => {
        setField(null);
        open.blur();
        open.inputMode = "text";
        spelled.current = open;
        open.focus();
      }}
    />
  );
}
