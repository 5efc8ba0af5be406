// Calls that come after some seconds of the world's time, once or again and again. Source: engine file TimerManager.h.
#pragma once

#include "CoreMinimal.h"
#include "Delegates/Delegate.h"
#include "Engine/TimerHandle.h"
#include "RunningCode.h"

#include <vector>

DECLARE_DELEGATE(FTimerDelegate)

class DRYDOCK_API FTimerManager
{
public:
	/** Rate: seconds; 0 and below only clears the handle's timer. FirstDelay: before the first call; below 0: Rate. A
	 * method is not called once its object is gone. */
	void SetTimer(FTimerHandle& InOutHandle, const FTimerDelegate& Delegate, float Rate, bool bLoop = false,
		float FirstDelay = -1.0f);
	void SetTimer(FTimerHandle& InOutHandle, TFunction<void()>&& Callback, float Rate, bool bLoop = false,
		float FirstDelay = -1.0f)
	{
		SetTimer(InOutHandle, FTimerDelegate::CreateLambda(std::move(Callback)), Rate, bLoop, FirstDelay);
	}
	template<typename T, typename TMethod>
	requires std::is_member_function_pointer_v<TMethod>
	void SetTimer(
		FTimerHandle& InOutHandle, T* Object, TMethod Method, float Rate, bool bLoop = false, float FirstDelay = -1.0f)
	{
		SetTimer(InOutHandle, FTimerDelegate::CreateUObject(Object, Method), Rate, bLoop, FirstDelay);
	}

	/** In the next frame. */
	FTimerHandle SetTimerForNextTick(const FTimerDelegate& Delegate);
	FTimerHandle SetTimerForNextTick(TFunction<void()>&& Callback)
	{
		return SetTimerForNextTick(FTimerDelegate::CreateLambda(std::move(Callback)));
	}
	template<typename T, typename TMethod>
	requires std::is_member_function_pointer_v<TMethod> FTimerHandle SetTimerForNextTick(T* Object, TMethod Method)
	{
		return SetTimerForNextTick(FTimerDelegate::CreateUObject(Object, Method));
	}

	void ClearTimer(FTimerHandle& InOutHandle);
	void ClearAllTimersForObject(const void* Object);
	void PauseTimer(FTimerHandle Handle);
	void UnPauseTimer(FTimerHandle Handle);
	bool TimerExists(FTimerHandle Handle) const { return Find(Handle) != nullptr; }
	bool IsTimerActive(FTimerHandle Handle) const { return TimerExists(Handle) && !Find(Handle)->bPaused; }
	bool IsTimerPaused(FTimerHandle Handle) const { return TimerExists(Handle) && Find(Handle)->bPaused; }
	/** Seconds; -1 where there is no such timer. */
	float GetTimerRate(FTimerHandle Handle) const;
	float GetTimerRemaining(FTimerHandle Handle) const;
	float GetTimerElapsed(FTimerHandle Handle) const;

	/** Ours: those that a plugin has set, before it goes. */
	void ClearAllTimersOf(const std::string& Plugin)
	{
		std::erase_if(Timers, [&](const FTimer& Timer) { return Timer.Owner.Plugin == Plugin; });
	}

	/** Calls what is due, in the order of the times; a timer that loops as often as its rate fits in. */
	void Tick(float DeltaTime);

private:
	struct FTimer
	{
		uint64 Id = 0;
		FTimerDelegate Delegate = {};
		double Rate = 0.0;
		bool bLoop = false;
		bool bPaused = false;
		double Due = 0.0; // on Now's clock; of a paused one what remains
		Drydock::FCodeOwner Owner = {};
	};

	FTimer& Add(const FTimerDelegate& Delegate, double Delay);
	FTimer* Find(FTimerHandle Handle) const;

	mutable std::vector<FTimer> Timers;
	double Now = 0.0; // s
	uint64 LastId = 0;
};
