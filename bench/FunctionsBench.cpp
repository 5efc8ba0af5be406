// What a shader's elementary functions cost: nanoseconds and, at the clock that a chain of additions shows, cycles per
// 16 lanes, in the cache, on the widest float lanes of the CPU. Medians of rounds in which every function is measured
// once. Prints a table in Markdown.
//
//     bench_functions [ROUNDS]
#include "FunctionsKernels.h"
#include "LanesDispatch.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

namespace Drydock::Bench
{
namespace
{

constexpr int GRepetitions = 50;

double ThreadNanoseconds()
{
	timespec Time;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &Time);
	return 1e9 * double(Time.tv_sec) + double(Time.tv_nsec);
}

/** Each addition waits a cycle for the one before. */
double MeasureGigahertz()
{
	constexpr int NumAdditions = 1 << 20;
	const double Begin = ThreadNanoseconds();
	uint64_t Sum = 0;
	for (int Index = 0; Index < NumAdditions / 8; ++Index)
	{
		asm volatile("add $1, %0\n\tadd $1, %0\n\tadd $1, %0\n\tadd $1, %0\n\t"
					 "add $1, %0\n\tadd $1, %0\n\tadd $1, %0\n\tadd $1, %0"
					 : "+r"(Sum));
	}
	return NumAdditions / (ThreadNanoseconds() - Begin);
}

double Median(std::vector<double> Values)
{
	std::nth_element(Values.begin(), Values.begin() + long(Values.size() / 2), Values.end());
	return Values[Values.size() / 2];
}

/** Arguments as colours are: above 0 and up to 4. */
void PrintTable(const FFunctionKernel* Functions, int Lanes, int Rounds)
{
	alignas(64) static float A[GNumFunctionValues];
	alignas(64) static float B[GNumFunctionValues];
	alignas(64) static float Out[GNumFunctionValues];
	std::mt19937 Engine(1);
	std::uniform_real_distribution<float> Value(0.01f, 4.0f);
	std::generate(std::begin(A), std::end(A), [&] { return Value(Engine); });
	std::generate(std::begin(B), std::end(B), [&] { return Value(Engine); });
	size_t NumFunctions = 0;
	while (Functions[NumFunctions].Name)
	{
		++NumFunctions;
	}
	std::vector<std::vector<double>> Times(NumFunctions);
	std::vector<double> Gigahertz;
	for (int Round = 0; Round < Rounds; ++Round)
	{
		Gigahertz.push_back(MeasureGigahertz());
		for (size_t Function = 0; Function < NumFunctions; ++Function)
		{
			Functions[Function].Loop(A, B, Out); // brings code and numbers into the cache
			const double Begin = ThreadNanoseconds();
			for (int Repetition = 0; Repetition < GRepetitions; ++Repetition)
			{
				Functions[Function].Loop(A, B, Out);
				asm volatile("" : : "r"(Out) : "memory");
			}
			Times[Function].push_back((ThreadNanoseconds() - Begin) * 16 / (double(GRepetitions) * GNumFunctionValues));
		}
	}
	std::printf("| per 16 lanes, %d at once | ns | cycles |\n|---|--:|--:|\n", Lanes);
	for (size_t Function = 0; Function < NumFunctions; ++Function)
	{
		const double Nanoseconds = Median(Times[Function]);
		std::printf("| %s | %.1f | %.0f |\n", Functions[Function].Name, Nanoseconds, Nanoseconds * Median(Gigahertz));
	}
}

} // namespace
} // namespace Drydock::Bench

int main(int ArgumentCount, char** Arguments)
{
	using namespace Drydock;
	const int Rounds = ArgumentCount > 1 ? std::max(1, std::atoi(Arguments[1])) : 31;
	// As kernels run: denormals are zero.
	__builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);
	if (AreLanesSupported(false, 16))
	{
		Bench::PrintTable(Bench::GetFunctionsAvx512(), 16, Rounds);
	}
	else if (AreLanesSupported(false, 8))
	{
		Bench::PrintTable(Bench::GetFunctionsAvx2(), 8, Rounds);
	}
	else
	{
		std::fprintf(stderr, "bench_functions needs AVX2\n");
	}
	return 0;
}
