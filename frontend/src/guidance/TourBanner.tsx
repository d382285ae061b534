import { useEffect } from "react";
import { PressButton } from "../controls/PressButton";
import banner from "../frame/Banners.module.css";
import { t } from "../state/language";
import { usePage } from "../state/router";
import { useLive } from "../state/store";
import { goOnWithTour, leaveTour, TOUR, useTour } from "./tour";

/** A part of the tour, on the first page of the first visit; it covers nothing, and everything can be
 *  used meanwhile. */
export function TourBanner() {
  const part = useTour();
  const page = usePage();
  const isFree = useLive((s) => s.session?.you != null && !s.demonstration?.running && s.replay === null);
  const shown = part === null || !isFree || page !== "home" ? undefined : TOUR[part];
  const pointed = shown?.part;
  useEffect(() => {
    if (pointed) document.documentElement.dataset.tour = pointed;
    return () => {
      delete document.documentElement.dataset.tour;
    };
  }, [pointed]);
  if (part === null || !shown) return null;
  const isLast = part + 1 === TOUR.length;
  return (
    <div className={banner.banner} data-quality="neutral" role="status">
      <div className={banner.words}>
        <strong>
          {t("ui-tour-part", { n: part + 1, all: TOUR.length })} {t(shown.title)}
        </strong>
        <span>{t(shown.text)}</span>
      </div>
      <PressButton free onPress={goOnWithTour}>
        {isLast ? t("ui-tour-end") : t("ui-tour-go-on")}
      </PressButton>
      {!isLast && (
        <PressButton free kind="quiet" onPress={leaveTour}>
          {t("ui-tour-end")}
        </PressButton>
      )}
    </div>
  );
}
