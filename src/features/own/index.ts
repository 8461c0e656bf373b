/* Own cycles: unknown here, described by the operator. */

export const fetchOwnPage = () => import("./OwnPage.tsx");
