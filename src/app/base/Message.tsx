import type { HTMLAttributes } from "react";
import { Icon } from "./Icon.tsx";
import { Unbroken } from "./Unbroken.tsx";

interface Props extends HTMLAttributes<HTMLElement> {
  readonly tone: "error" | "warning" | "info";
  readonly as?: "p" | "div" | "span" | "li";
}

/** A sentence with an icon in the colour of its severity: an error of a field, or a note in a dialog. */
export function Message({ tone, as: Element = "p", className = "", children, ...rest }: Props) {
  return (
    <Element {...rest} className={`field-message ${tone} ${className}`.trim()}>
      <Icon name={tone} />
      {typeof children === "string" ? <Unbroken text={children} /> : children}
    </Element>
  );
}
