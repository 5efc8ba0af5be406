// Runs lane code with the lanes of the run.
#pragma once

#include "CoreTypes.h"

namespace Drydock
{

/** The float lanes that native kernels run on, 4, 8 or 16: those that r.Drydock.Lanes asks for, where this build and
 * this CPU have so many, else the widest. Throws FError (DD6003) where this build has code for no instruction set of
 * this CPU. */
DRYDOCK_API int32 GetNativeLanes();

/** Calls Function with a TLanes<N>, N being GetNativeLanes(), and returns what it returns. Functions of TLanes are weak
 * symbols: a build for one instruction set lacks the others'. */
template<template<int> class TLanes, typename TFunction>
auto WithNativeLanes(const TFunction& Function)
{
	switch (GetNativeLanes())
	{
	case 16:
		return Function(TLanes<16>());
	case 8:
		return Function(TLanes<8>());
	default:
		return Function(TLanes<4>());
	}
}

} // namespace Drydock
