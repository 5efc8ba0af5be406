// Curves without an asset: keys in a text that stands where a curve's path would, "linear(-4 1, 0 0, 4 -1)", so that
// equal keys are one object and the ledger shows them. How a config's keys become that text: Config/ConfigCurves.cpp.
#pragma once

#include "Curves/CurveFloat.h"
#include "Curves/RichCurve.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** "linear", "constant", "cubic", by ERichCurveInterpMode. */
DRYDOCK_API const std::vector<std::string>& GetCurveInterpNames();

/** "linear(0 1, 2 3)". All keys of one mode, times ascending, values finite. */
DRYDOCK_API std::string WriteCurveKeys(const FRichCurve& Curve);

/** Reads a text of WriteCurveKeys, cubic ones with automatic tangents; empty for every other text. */
DRYDOCK_API std::optional<FRichCurve> ReadCurveKeys(const std::string& Text);

/** The keys of a curve that was named by such a text; empty for null and for an asset, which nothing loads. */
DRYDOCK_API std::optional<FRichCurve> FindCurveKeys(const UCurveFloat* Curve);

} // namespace Drydock
