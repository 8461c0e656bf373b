/* Cycles that this edition does not know, described by the operator. */

export const fetchOwnPage = () => import("./OwnPage.tsx");
