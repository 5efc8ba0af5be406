// Checks that the weights of a blur form a blur: a wrong table, hard to find in the engine, is reported here.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

class FRDGBuilder;

namespace Drydock
{

/** Properties of the weights of one direction. */
struct FKernelAudit
{
	/** The factor by which a pass multiplies the light. */
	double Sum = 0.0;
	bool bFinite = true;
	bool bNegative = false;
	/** Equal on both sides of the middle, within 1e-6 of the largest. */
	bool bSymmetric = true;
	/** Never rises away from the middle by more than 1e-6 of the largest. */
	bool bOneLobe = true;

	/** Finite, not negative, symmetric, one lobe, and a sum within 1e-3 of 1. */
	DRYDOCK_API bool IsSound() const;

	/** "weights sum to 1.9952, which each pass multiplies the light by; ..."; empty where it is sound. */
	DRYDOCK_API std::string DescribeFaults() const;
};

/** Weights: from the first tap to the last, equally far apart; the middle one, or the middle two, are the centre. */
DRYDOCK_API FKernelAudit AuditKernel(const std::vector<double>& Weights);

enum class EKernelFault
{
	None,    // the kernel is meant to be sound
	Printed, // it is faulty as its article prints it, and kept so
};

/** Checks the kernel of a pass that has a table of weights: refuses a faulty kernel (throws FError DD2101, exit code
 * 2), or, where it is declared, leaves a warning on the graph (DD2100). Name: "RED blur". */
DRYDOCK_API void CheckKernel(
	FRDGBuilder& GraphBuilder, const std::string& Name, const std::vector<double>& Weights, EKernelFault Declared);

} // namespace Drydock
