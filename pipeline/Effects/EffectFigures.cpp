// Finds a figure among those that an effect came to.
#include "Effects/EffectFigures.h"

#include <limits>

namespace Drydock
{

double FEffectFigures::Get(const std::string& Group, const std::string& Figure) const
{
	for (const FFigureGroup& Candidate : Groups)
	{
		for (const FFigure& Found : Candidate.Figures)
		{
			if (Candidate.Name != Group || Found.Name != Figure)
			{
				continue;
			}
			if (const uint64_t* const Count = std::get_if<uint64_t>(&Found.Value))
			{
				return static_cast<double>(*Count);
			}
			if (const double* const Number = std::get_if<double>(&Found.Value))
			{
				return *Number;
			}
		}
	}
	return std::numeric_limits<double>::quiet_NaN();
}

} // namespace Drydock
