// What every report page carries; the texts are made at build time (embed_assets.cmake).
#pragma once

namespace phs::report {

extern const char kPageTemplate[];        ///< HTML with the marks @TITLE@, @STYLE@, @BODY@ …
extern const char kPageStyle[];           ///< CSS of the plotting library and of the page
extern const char kPageScript[];          ///< JavaScript of the plotting library and of the page
extern const char kPlotLibraryLicence[];  ///< licence text of the plotting library
/// The replay in three dimensions with its library (web/scene.js bundled), for pages with a film.
extern const char kSceneScript[];
extern const char kSceneLibraryLicence[];

}  // namespace phs::report
