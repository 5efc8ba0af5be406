// A kernel without an end ends the program with a message; one that goes on, however slowly, does not.
#include <chrono>
#include <thread>

#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"
#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

void Sleep(int Milliseconds)
{
	std::this_thread::sleep_for(std::chrono::milliseconds(Milliseconds));
}

void Hang(const FKernelArgs&, const FKernelTile&)
{
	Sleep(100'000);
}

/** Slower than the limit altogether, and no single tile is. */
void Dawdle(const FKernelArgs&, const FKernelTile&)
{
	Sleep(100);
}

void Dispatch(FKernelFunction Kernel, const char* Seconds, uint32 NumGroups)
{
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.ShaderSeconds"))->Set(Seconds, ECVF_SetByCode);
	FBoundShader Shader = MakeShader(EShaderStage::Compute, Kernel);
	Shader.Name = "FEndlessCS";
	Shader.EntryPoint = "MainCS";
	FRHICommandListImmediate RHICmdList;
	RHICmdList.SetBoundComputeShader(std::move(Shader));
	RHICmdList.DispatchComputeShader(1, 1, NumGroups);
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.ShaderSeconds"))->Set("300", ECVF_SetByCode);
}

} // namespace

TEST(KernelWatchDeathTest, AKernelWithoutAnEndEndsTheProgramWithAMessage)
{
	GTEST_FLAG_SET(death_test_style, "threadsafe"); // the watcher is a thread
	EXPECT_EXIT(Dispatch(Hang, "0.5", 1), testing::ExitedWithCode(ExitUsage),
		"error DD6040.*FEndlessCS.*MainCS.*0\\.5 s.*r\\.Drydock\\.ShaderSeconds");
}

TEST(KernelWatch, AKernelThatGoesOnMayTakeItsTime)
{
	// 100 slices on at most 4 threads: 2.5 s or more.
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Threads"))->Set("4", ECVF_SetByCode);
	Dispatch(Dawdle, "2", 100);
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Threads"))->Set("0", ECVF_SetByCode);
}

TEST(KernelWatch, WithoutALimitNobodyLooks)
{
	Dispatch(Dawdle, "0", 1);
}
