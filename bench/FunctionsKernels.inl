// Body of FunctionsKernels.h: included with DRYDOCK_BENCH_LANES and DRYDOCK_BENCH_GETTER set.
#include "FunctionsKernels.h"
#include "Lanes.h"

namespace Drydock::Bench
{
namespace
{

using FReal = Lanes::TReal<float, DRYDOCK_BENCH_LANES>;

template<typename F>
void Loop(const float* A, const float* B, float* Out, F Function)
{
	for (int Index = 0; Index < GNumFunctionValues; Index += DRYDOCK_BENCH_LANES)
	{
		FReal X;
		FReal Y;
		__builtin_memcpy(&X.V, A + Index, sizeof(X.V));
		__builtin_memcpy(&Y.V, B + Index, sizeof(Y.V));
		const FReal Result = Function(X, Y);
		__builtin_memcpy(Out + Index, &Result.V, sizeof(Result.V));
	}
}

#define DRYDOCK_BENCH_FUNCTION(Name, Expression) \
	{ \
		Name, [](const float* A, const float* B, float* Out) \
		{ \
			Loop(A, B, Out, [](FReal X, [[maybe_unused]] FReal Y) { return Expression; }); \
		} \
	}

const FFunctionKernel GFunctions[] = {
	DRYDOCK_BENCH_FUNCTION("copy", X),
	DRYDOCK_BENCH_FUNCTION("multiply", X* Y),
	DRYDOCK_BENCH_FUNCTION("divide", X / Y),
	DRYDOCK_BENCH_FUNCTION("max", Lanes::Max(X, Y)),
	DRYDOCK_BENCH_FUNCTION("floor", Lanes::Floor(X)),
	DRYDOCK_BENCH_FUNCTION("sqrt", Lanes::Sqrt(X)),
	DRYDOCK_BENCH_FUNCTION("exp2", Lanes::Exp2(X)),
	DRYDOCK_BENCH_FUNCTION("exp", Lanes::Exp(X)),
	DRYDOCK_BENCH_FUNCTION("log2", Lanes::Log2(X)),
	DRYDOCK_BENCH_FUNCTION("pow", Lanes::Pow(X, Y)),
	DRYDOCK_BENCH_FUNCTION("sin", Lanes::Sin(X)),
	DRYDOCK_BENCH_FUNCTION("atan2", Lanes::Atan2(X, Y)),
	{nullptr, nullptr},
};

#undef DRYDOCK_BENCH_FUNCTION

} // namespace

const FFunctionKernel* DRYDOCK_BENCH_GETTER()
{
	return GFunctions;
}

} // namespace Drydock::Bench
