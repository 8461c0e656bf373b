/* The part of this feature that the first screen needs. */

export { SharedSetupLine as HandedLine, IncomingWork } from "./SharedParts.tsx";
