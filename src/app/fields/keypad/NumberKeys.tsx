import { Suspense, useEffect, useRef, useState } from "react";
import { lazyPart } from "../../base/parts.ts";
import { holds } from "../../base/use-media.ts";
import { numberFieldOf } from "./field-typing.ts";

const FieldKeypad = lazyPart(async () => ({ default: (await import("./FieldKeypad.tsx")).FieldKeypad }));

/**
 * Brings the keypad to every number field of the app (an input marked with `data-number`) where fingers work, and keeps
 * the keyboard of the device away from it, which would cover the picture. Fields for names keep that keyboard.
 */
export function NumberKeys() {
  const [field, setField] = useState<HTMLInputElement | null>(null);
  /** The last press was by a finger or a pen. */
  const touched = useRef(false);
  /** The field that was just come to. */
  const fresh = useRef<HTMLInputElement | null>(null);
  /** The field for which the keyboard of the device was asked for. */
  const spelled = useRef<HTMLInputElement | null>(null);

  useEffect(() => {
    const onPress = (e: PointerEvent) => {
      touched.current = e.pointerType !== "mouse";
      const pressed = numberFieldOf(e.target);
      if (pressed && touched.current && spelled.current !== pressed) pressed.inputMode = "none";
    };
    const onFocus = (e: FocusEvent) => {
      const focused = numberFieldOf(e.target),
        fits = focused !== null && (touched.current || holds("coarse"));
      if (fits && spelled.current !== focused) {
        focused.inputMode = "none";
        fresh.current = focused;
        setField(focused);
      }
    };
    // As in the prompts, what is typed first takes the place of what stands there; the next touch sets the caret. The
    // field may have moved away under the finger when its keypad came.
    const onClick = () => {
      if (fresh.current !== null && fresh.current === document.activeElement) fresh.current.select();
      fresh.current = null;
    };
    // A key that is the first click since then writes over the old text: selected behind it, its digit would be lost to
    // the next one.
    const onKey = ({ target }: MouseEvent) => {
      if (target instanceof Element && target.closest(".field-keypad")) onClick();
    };
    // A field that is taken out of the page is not always left first. The page moves when the keypad goes: only when
    // the tap that took the keyboard elsewhere has met what it was for.
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
    <Suspense>
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
    </Suspense>
  );
}
