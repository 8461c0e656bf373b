import type { HTMLAttributes } from "react";
import { Icon } from "./Icon.tsx";

interface Props extends HTMLAttributes<HTMLElement> {
  readonly tone: "error" | "warning" | "info";
  readonly as?: "p" | "div" | "span" | "li";
}

/**
 * A sentence with its icon in the colour of how bad it is: what is wrong with a field, or worth knowing of a dialog.
 */
export function Message({ tone, as: Element = "p", className = "", children, ...rest }: Props) {
  return (
    <Element {...rest} className={`field-message ${tone} ${className}`.trim()}>
      <Icon name={tone} />
      {children}
    </Element>
  );
}
